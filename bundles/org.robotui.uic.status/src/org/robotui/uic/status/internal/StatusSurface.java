package org.robotui.uic.status.internal;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.PortKind;
import org.robotui.api.show.Subject;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowList;
import org.robotui.ui.show.DraggedPorts;
import org.robotui.ui.show.PortDrag;
import org.robotui.ui.show.SubjectMenu;

/** What is seen of the view while it is shown: a line of controls, and the list. Display thread. */
final class StatusSurface implements ViewSurface {
  private static final int WIDEST_FILTER = 180;
  private static final int LEAST_FILTER = 120;

  private final UiContext context;
  private final Composite root;
  private final Composite bar;
  private final QuietButton ports;
  private final QuietButton connections;
  private final FilterField filter;
  private final QuietButton stop;
  private final QuietButton release;
  private final RowPainter painter;
  private final RowList<StatusRow> list;

  StatusSurface(Composite parent, UiContext context, StatusUic.Actions actions, String ruic, SubjectMenu subjects) {
    this.context = context;
    this.root = Boxes.panel(parent, context.theme(), 1);
    this.bar = Boxes.bar(root, context.theme(), 6);
    this.ports = new QuietButton(bar, context.theme(), () -> actions.connections(false)).text("Ports");
    ports.setLayoutData(Boxes.middle());
    this.connections = new QuietButton(bar, context.theme(), () -> actions.connections(true)).text("Connections");
    connections.setLayoutData(Boxes.middle());
    stretch();
    this.filter = filter(bar, actions);
    this.stop = button(bar, actions::stop, "Stop " + actions.robots())
        .hint("Stop " + actions.robots() + " until the stop is released");
    this.release = button(bar, actions::releaseStop, "Release " + actions.robots()).fill(Role.ACCENT);
    sameWidth(stop, release);
    this.painter = new RowPainter(context.theme());
    this.list = new RowList<>(root, context.theme(), painter).named("Status").onFind(filter::focus);
    list.control().setLayoutData(Boxes.fill());
    filter.onDown(list.control()::setFocus);
    bar.addListener(SWT.Resize, e -> fit());
    list.menu((menu, rows) -> rows.forEach(row -> menu(menu, row, subjects)));
    PortDrag.from(list.control(), at -> Optional
        .of(new DraggedPorts(ruic, list.selected().stream().flatMap(row -> stream(row).stream()).toList())));
  }

  private static void menu(PopupMenu menu, StatusRow row, SubjectMenu subjects) {
    stream(row).ifPresentOrElse(stream -> subjects.fill(menu, stream),
        () -> menu.push("Copy text", () -> Clipboards.copy(row.details())));
  }

  private static Optional<Subject.Stream> stream(StatusRow row) {
    return row instanceof PortRow port && port.port().kind() == PortKind.STREAM
        ? Optional.of(Subject.Stream.of(port.port().port()))
        : Optional.empty();
  }

  @Override
  public Control control() {
    return root;
  }

  void show(Page page) {
    if (root.isDisposed()) {
      return;
    }
    context.note(page.note());
    ports.checked(!page.connections());
    connections.checked(page.connections());
    boolean stopped = page.stoppedBy().isPresent();
    release.hint(page.stoppedBy().map(by -> "Stopped by " + by).orElse("Stopped") + "; nothing moves by releasing it");
    if (Boxes.seen(stop, !stopped) | Boxes.seen(release, stopped)) {
      root.layout(true, true);
    }
    fit();
    page.trouble().ifPresentOrElse(t -> list.message(t.health(), t.title(), t.sentence()), list::noMessage);
    painter.show(page.rows());
    list.show(page.rows());
  }

  /** The one that replaces the other takes the same room, so that nothing moves. */
  private static void sameWidth(QuietButton one, QuietButton other) {
    int width = Math.max(one.computeSize(SWT.DEFAULT, SWT.DEFAULT).x, other.computeSize(SWT.DEFAULT, SWT.DEFAULT).x);
    ((GridData) one.getLayoutData()).widthHint = width;
    ((GridData) other.getLayoutData()).widthHint = width;
  }

  /** The stop is never cut: where it is narrow, the filter goes first, then the button of what is shown already. */
  private void fit() {
    int width = bar.getClientArea().width;
    int buttons = needed(ports) + needed(connections) + ((GridData) stop.getLayoutData()).widthHint + 4 * Theme.STEP
        + 2 * Theme.STEP;
    boolean narrow = width < buttons;
    boolean tabs =
        Boxes.seen(ports, !narrow || !ports.isChecked()) | Boxes.seen(connections, !narrow || !connections.isChecked());
    boolean filters = width >= buttons + LEAST_FILTER;
    ((GridData) filter.getLayoutData()).widthHint = Math.clamp(width - buttons, LEAST_FILTER, WIDEST_FILTER);
    if (!filters && !filter.words().isEmpty()) {
      filter.words("");
    }
    if (Boxes.seen(filter, filters) | tabs | filters) {
      bar.layout();
    }
  }

  private static int needed(QuietButton button) {
    return button.computeSize(SWT.DEFAULT, SWT.DEFAULT).x + Theme.STEP;
  }

  /** Keeps the tabs at the left and the rest at the right, whichever of them are seen. */
  private void stretch() {
    GridData data = Boxes.line(1);
    data.widthHint = 0;
    Boxes.panel(bar, context.theme(), 1).setLayoutData(data);
  }

  private FilterField filter(Composite bar, StatusUic.Actions actions) {
    // A control that is made anew begins without words.
    actions.filter("");
    FilterField field = new FilterField(bar, context.theme(), "Filter", actions::filter);
    GridData data = new GridData(SWT.END, SWT.CENTER, false, false);
    data.widthHint = WIDEST_FILTER;
    field.setLayoutData(data);
    return field;
  }

  private QuietButton button(Composite bar, Runnable action, String text) {
    QuietButton button = new QuietButton(bar, context.theme(), action).text(text);
    button.setLayoutData(new GridData(SWT.END, SWT.CENTER, false, false));
    return button;
  }
}
