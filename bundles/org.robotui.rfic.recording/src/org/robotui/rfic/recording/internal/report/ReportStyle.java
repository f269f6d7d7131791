package org.robotui.rfic.recording.internal.report;

/** How a report looks, on the screen, in the dark and on paper. */
final class ReportStyle {
  static final String CSS = """
      :root { --ink: #1c2430; --dim: #5b6675; --line: #dde2e8; --panel: #f4f6f9; --page: #ffffff;
        --warning: #b36b00; --bad: #c0392b; --c0: #0b63c5; --c1: #b36b00; --c2: #0c7a43; --c3: #7140c0; --c4: #8a4b2a;
        --c5: #b52f80; }
      @media (prefers-color-scheme: dark) { :root { --ink: #e4e8ee; --dim: #96a1b0; --line: #333b46; --panel: #262c35;
        --page: #1e232a; --warning: #e5a53b; --bad: #ef6a5b; --c0: #4da3ff; --c1: #e5a53b; --c2: #3fbf7f; --c3: #b58cf0;
        --c4: #c98f6a; --c5: #f07fc0; } }
      body { font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif; color: var(--ink); background: var(--page);
        max-width: 1000px; margin: 0 auto; padding: 24px 16px 48px; }
      h1 { font-size: 26px; margin: 0 0 4px; overflow-wrap: anywhere; }
      h2 { font-size: 17px; margin: 36px 0 10px; border-bottom: 1px solid var(--line); padding-bottom: 6px;
        overflow-wrap: anywhere; }
      header p, footer, small, figcaption { color: var(--dim); }
      footer { margin-top: 40px; font-size: 13px; }
      table { border-collapse: collapse; width: 100%; font-size: 14px; }
      th { text-align: left; color: var(--dim); font-weight: 500; }
      th, td { padding: 4px 14px 4px 0; border-bottom: 1px solid var(--line); vertical-align: top;
        overflow-wrap: anywhere; }
      td:first-child { white-space: nowrap; }
      .number { font-variant-numeric: tabular-nums; white-space: nowrap; }
      .level { white-space: nowrap; }
      .warning .level, .warning td:last-child.number { color: var(--warning); }
      .error .level, .fatal .level { color: var(--bad); font-weight: 600; }
      .problems { background: var(--panel); border-left: 4px solid var(--bad); padding: 1px 16px; margin-top: 20px; }
      .problems h2 { border: 0; margin-top: 12px; }
      svg { width: 100%; height: auto; display: block; }
      svg text { font: 11px system-ui, "DejaVu Sans", sans-serif; fill: var(--dim); }
      .name, .value { text-anchor: end; } .tick { text-anchor: middle; }
      .grid { stroke: var(--line); stroke-width: 1; }
      .lane { fill: var(--c0); } .gap { fill: var(--bad); opacity: 0.75; }
      .line { fill: none; stroke: var(--c0); stroke-width: 1.4; stroke-linejoin: round; }
      .path { fill: none; stroke-width: 2; stroke-linejoin: round; }
      .ruler { stroke: var(--dim); stroke-width: 2; }
      .start { fill: var(--page); stroke-width: 2; }
      .c0 { stroke: var(--c0); color: var(--c0); } .c1 { stroke: var(--c1); color: var(--c1); }
      .c2 { stroke: var(--c2); color: var(--c2); } .c3 { stroke: var(--c3); color: var(--c3); }
      .c4 { stroke: var(--c4); color: var(--c4); } .c5 { stroke: var(--c5); color: var(--c5); }
      .end { fill: currentColor; stroke: none; }
      .legend { list-style: none; padding: 0; margin: 8px 0 0; font-size: 14px; }
      .legend li::before { content: "\\25CF\\00A0"; }
      figure { margin: 0 0 14px; } figcaption { font-size: 13px; margin-bottom: 2px; }
      .pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(220px, 1fr)); gap: 12px; }
      .pictures img { width: 100%; height: auto; border-radius: 4px; }
      @media print { body { max-width: none; padding: 0; } section { break-inside: avoid; } }
      """;

  private ReportStyle() {}
}
