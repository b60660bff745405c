import { defineConfig } from 'vite';

// Classic scripts and one style sheet, which are inlined into reports: a report must work from a
// file: address and load nothing else. `vite build` makes the script of the figures and the style;
// `vite build --mode sheets` that of the three-dimensional views, which not every report needs.
export default defineConfig(({ mode }) => {
  const entry = mode === 'sheets' ? 'sheets' : 'report';
  return {
    build: {
      outDir: 'dist',
      emptyOutDir: false,
      cssCodeSplit: false,
      lib: {
        entry: `src/${entry}.js`,
        name: entry === 'sheets' ? 'PliantSheets' : 'PliantReport',
        formats: ['iife'],
        fileName: () => `${entry}.js`,
        cssFileName: 'report',
      },
    },
  };
});
