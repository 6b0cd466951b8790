import react from '@vitejs/plugin-react';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { defineConfig } from 'vitest/config';

const here = fileURLToPath(new URL('.', import.meta.url));
const console_address = process.env['TACIT_CONSOLE'] ?? 'http://127.0.0.1:8080';

/** The unit tests stand outside this folder; what they import is found as if they stood in it. */
const packages_for_tests: Plugin = {
  name: 'packages-for-tests',
  enforce: 'pre',
  resolveId(source, importer) {
    const is_package = /^[a-z@]/i.test(source) && !source.startsWith('@/');
    if (!is_package || !importer?.includes('/tests/web/')) return null;
    return this.resolve(source, `${here}src/main.tsx`, { skipSelf: true });
  },
};

export default defineConfig({
  plugins: [packages_for_tests, react()],
  resolve: { alias: { '@': `${here}src` } },
  build: { target: 'es2022', assetsInlineLimit: 0, modulePreload: { polyfill: false } },
  server: {
    fs: { allow: ['../..'] },
    proxy: {
      '/api': console_address,
      '/ws': { target: console_address, ws: true },
    },
  },
  test: {
    globals: true,
    environment: 'happy-dom',
    include: ['../../tests/web/unit/**/*.test.{ts,tsx}'],
  },
});
