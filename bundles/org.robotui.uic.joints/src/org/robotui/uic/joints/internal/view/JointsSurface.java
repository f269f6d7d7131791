package org.robotui.uic.joints.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.joints.internal.model.Export;
import org.robotui.uic.joints.internal.model.JointRow;
import org.robotui.uic.joints.internal.model.JointsLook;

/**
 * What is seen of the view while it is shown: a line of controls and the table. Display thread, but for
 * {@link #prepare}.
 */
public final class JointsSurface implements ViewSurface {
  private static final int WIDEST_FILTER = 160;
  private static final int STRIP_HEIGHT = 26;

  /** What is to be painted. */
  private record Shown(JointsLook look, List<JointRow> rows) {}

  private final UiContext context;
  private final String ruic;
  private final SubjectMenu subjects;
  private final Composite root;
  private final SourceStrip sources;
  private final FilterField filter;
  private JointColumns kind = new JointColumns(false, false, false);
  private volatile JointTable table;
  private volatile String words = "";
  private volatile Optional<Shown> shown = Optional.empty();

  /** Makes the controls. */
  public JointsSurface(Composite parent, UiContext context, String ruic, SubjectMenu subjects) {
    this.context = context;
    this.ruic = ruic;
    this.subjects = subjects;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    Composite bar = Boxes.bar(root, theme, 2);
    ((GridLayout) bar.getLayout()).horizontalSpacing = 2 * Theme.STEP;
    sources = new SourceStrip(bar, theme);
    GridData middle = Boxes.line(STRIP_HEIGHT);
    middle.widthHint = 0;
    sources.control().setLayoutData(middle);
    filter = new FilterField(bar, theme, "Filter joints", this::search);
    GridData right = new GridData(SWT.END, SWT.CENTER, false, false);
    right.widthHint = WIDEST_FILTER;
    filter.setLayoutData(right);
    filter.onDown(() -> table.list().control().setFocus());
    table = table();
  }

  private boolean focus() {
    return table.list().control().setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Filters and sorts what is to be shown next. Any thread. */
  public void prepare(JointsLook look) {
    shown = Optional.of(new Shown(look, table.table().sorted(look.matching(words))));
  }

  /** Shows what was prepared. */
  public void refresh() {
    if (!root.isDisposed()) {
      shown.ifPresent(this::show);
    }
  }

  /** Copies the selected rows, or all, as YAML. */
  public void copyYaml() {
    copy(Export::yaml);
  }

  /** Copies the selected rows, or all, as CSV. */
  public void copyCsv() {
    copy(Export::csv);
  }

  JointTable current() {
    return table;
  }

  FilterField filterField() {
    return filter;
  }

  private void copy(Function<List<JointRow>, String> text) {
    List<JointRow> selected = table.list().selected();
    Clipboards.copy(text.apply(selected.isEmpty() ? table.list().rows() : selected));
  }

  private void search(String typed) {
    words = typed;
    again();
    table.table().highlight(typed);
  }

  private void again() {
    shown.ifPresent(s -> prepare(s.look()));
    refresh();
  }

  private void show(Shown next) {
    context.note(next.look().note());
    sources.show(next.look().sources());
    columns(JointColumns.of(next.look()));
    table.table().show(next.rows());
    table.list().state(next.look().state());
    boolean empty = next.rows().isEmpty() && StateView.showsContent(next.look().state());
    if (!empty) {
      table.list().noMessage();
    } else if (next.look().joints().isEmpty()) {
      table.list().message(Health.NONE, "No joints", "The robot sends joint states without a joint in them.");
    } else {
      table.list().message(Health.NONE, "No match", "No joint contains these words. Esc clears the filter.");
    }
  }

  /** Makes another table where other columns are needed; what was selected and sorted stays so. */
  private void columns(JointColumns wanted) {
    if (wanted.equals(kind)) {
      return;
    }
    kind = wanted;
    JointTable old = table;
    boolean focused = old.list().control().isFocusControl();
    JointTable made = table();
    old.sorting().ifPresent(made::sort);
    old.list().selected().stream().findFirst().ifPresent(row -> made.list().select(row.key()));
    made.table().highlight(words);
    table = made;
    old.control().dispose();
    root.layout(true, true);
    if (focused) {
      made.list().control().setFocus();
    }
  }

  private JointTable table() {
    JointTable made = new JointTable(root, context.theme(), kind, ruic, subjects);
    made.control().setLayoutData(Boxes.fill());
    made.table().onOrder(this::again);
    made.list().onFind(filter::focus);
    return made;
  }
}
