package org.robotui.workbench.internal.pane;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.FileDialog;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.host.ReuseReport.Pair;
import org.robotui.api.host.ReuseReport.Row;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.RowTable;

/**
 * Which bundles are used by which robot UIs: what is shared in the colour of text, what is particular in an accent.
 * Drawn from what is installed and runs. Display thread only.
 */
public final class ReuseDialog {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 720;
  private static final int MOST_PAIRS = 6;
  private static final int DOT = 11;

  private final Theme theme;
  private final ReuseReport report;
  private final Shell shell;
  private final NoticeLine said;

  /** Makes the window, with a report as it is now. */
  public ReuseDialog(Shell parent, Theme theme, ReuseReport report) {
    this.theme = theme;
    this.report = report;
    shell = DialogShell.over(parent, theme, "Reuse of components");
    shell.setLayout(DialogShell.layout(1, 0, 0));
    head();
    RowTable<Row> table = new RowTable<>(shell, theme, columns(), Row::bundle);
    table.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    table.list().named("Bundles and the robot UIs that use them");
    table.onOrder(() -> table.show(table.sorted(report.rows())));
    table.show(report.rows());
    if (report.rows().isEmpty()) {
      table.list().message(Health.NONE, "No robot UI runs", "Open a configuration: its components are counted here.");
    }
    said = new NoticeLine(shell, theme, Face.BODY);
    buttons();
    DialogShell.place(shell, WIDTH, HEIGHT);
  }

  /** Shows it. */
  public void open() {
    shell.open();
  }

  /** The window, for tests. */
  public Shell shell() {
    return shell;
  }

  private void head() {
    Composite head = new Composite(shell, SWT.NONE);
    head.setBackground(theme.color(Role.TITLE));
    head.setLayout(DialogShell.layout(1, Theme.EDGE, Theme.STEP));
    head.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    words(head, Face.TITLE, Role.TEXT, capital(report.summary()));
    pairs().forEach(p -> words(head, Face.BODY, Role.DIM, p));
  }

  private List<String> pairs() {
    List<Pair> all = report.pairs();
    List<String> lines = new ArrayList<>(all.stream().limit(MOST_PAIRS)
        .map(p -> p.one() + " and " + p.other() + ": " + p.shared()
            + " shared, " + p.onlyOne() + " only in " + p.one() + ", " + p.onlyOther() + " only in " + p.other())
        .toList());
    if (all.size() > MOST_PAIRS) {
      lines.add("and " + (all.size() - MOST_PAIRS) + " more pairs, in the exported table");
    }
    return lines;
  }

  private void words(Composite parent, Face face, Role role, String text) {
    new ShortenedLabel(parent, theme, face, role, text).setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
  }

  private static String capital(String text) {
    return text.substring(0, 1).toUpperCase(Locale.ROOT) + text.substring(1);
  }

  private List<Column<Row>> columns() {
    List<Column<Row>> columns = new ArrayList<>();
    columns.add(Column.<Row>words("Kind", r -> word(r.kind())).role(Role.DIM).width(96).weight(0)
        .order((a, b) -> a.kind().compareTo(b.kind())));
    columns.add(Column.<Row>words("Component", Row::name).role(this::role).weight(1)
        .order((a, b) -> a.name().compareTo(b.name())));
    columns.add(Column.<Row>words("Bundle", Row::bundle).role(Role.DIM).weight(1.6)
        .order((a, b) -> a.bundle().compareTo(b.bundle())));
    for (String ruic : report.ruics()) {
      columns.add(Column.<Row>words(ruic, r -> r.users().contains(ruic) ? "used" : "")
          .painted((gc, at, r) -> dot(gc, at, r, ruic))
          .width(Math.clamp(600 / report.ruics().size(), 64, 110)).weight(0)
          .order((a, b) -> Boolean.compare(b.users().contains(ruic), a.users().contains(ruic))));
    }
    columns.add(Column.<Row>figures("Used by", r -> Integer.toString(r.users().size())).width(76)
        .order((a, b) -> b.users().size() - a.users().size()));
    return columns;
  }

  private static String word(ReuseReport.Kind kind) {
    return switch (kind) {
      case RUIC -> "robot UI";
      case RFIC -> "framework";
      case UIC -> "view";
      case ENTITY -> "entity";
      case BASE -> "base";
    };
  }

  /** Shared by all, by some, or particular. With a single robot UI nothing is either. */
  private Role role(Row row) {
    boolean alone = report.ruics().size() > 1 && row.users().size() == 1;
    return alone ? Role.ACCENT : Role.TEXT;
  }

  private void dot(GC gc, Rectangle at, Row row, String ruic) {
    int x = at.x + Theme.STEP;
    int y = at.y + (at.height - DOT) / 2;
    if (row.users().contains(ruic)) {
      gc.setBackground(theme.color(role(row)));
      gc.fillOval(x, y, DOT, DOT);
    } else {
      gc.setForeground(theme.color(Role.LINE));
      gc.setLineWidth(1);
      gc.drawLine(x + 2, y + DOT / 2, x + DOT - 2, y + DOT / 2);
    }
  }

  private void buttons() {
    Composite bar = new Composite(shell, SWT.NONE);
    bar.setBackground(theme.color(Role.TITLE));
    bar.setLayout(DialogShell.layout(4, Theme.EDGE, Theme.STEP));
    bar.setLayoutData(new GridData(SWT.FILL, SWT.BOTTOM, true, false));
    new Gap(bar).setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    DialogShell.button(bar, theme, this::copy).icon(Icon.COPY).text("Copy as Markdown");
    DialogShell.button(bar, theme, this::choose).icon(Icon.SAVE).text("Save\u2026");
    DialogShell.button(bar, theme, shell::close).icon(Icon.CLOSE).text("Close");
  }

  private void copy() {
    Clipboards.copy(report.markdown());
    said.show(Health.OK, "The table is in the clipboard.");
  }

  private void choose() {
    FileDialog dialog = new FileDialog(shell, SWT.SAVE);
    dialog.setText("Save the table");
    dialog.setFilterExtensions(new String[]{"*.csv", "*.md"});
    dialog.setFilterNames(new String[]{"Comma-separated values (*.csv)", "Markdown (*.md)"});
    dialog.setFileName("reuse.csv");
    dialog.setOverwrite(true);
    Optional.ofNullable(dialog.open()).map(Path::of).ifPresent(this::save);
  }

  /** As Markdown where the file is named so, else as comma-separated values. */
  void save(Path file) {
    Supplier<String> text = file.toString().endsWith(".md") ? report::markdown : report::csv;
    try {
      AtomicFile.write(file, text.get());
      said.show(Health.OK, "Saved as " + file);
    } catch (IOException e) {
      said.show(Health.BAD, file + " cannot be written: " + WriteFailure.reason(e));
    }
  }
}
