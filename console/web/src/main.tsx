import { createRoot } from 'react-dom/client';

import { App } from '@/app/App';
import '@/app/styles.css';

createRoot(document.getElementById('page')!).render(<App />);
