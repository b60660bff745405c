import { defineConfig } from 'vite';

// One classic script and one style sheet: both are inlined into every report, which must work
// from a file: address and load nothing else.
export default defineConfig({
  build: {
    outDir: 'dist',
    cssCodeSplit: false,
    lib: {
      entry: 'src/report.js',
      name: 'PliantReport',
      formats: ['iife'],
      fileName: () => 'report.js',
      cssFileName: 'report',
    },
  },
});
