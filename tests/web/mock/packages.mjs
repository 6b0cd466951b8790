// The tests stand outside console/web and use the packages that are installed there.
import { createRequire } from 'node:module';

export const need = createRequire(new URL('../../../console/web/package.json', import.meta.url));
