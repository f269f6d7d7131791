package org.robotui.uic.jointcontrol.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.StateView;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.RowList;
import org.robotui.uic.jointcontrol.internal.model.ChainHead;
import org.robotui.uic.jointcontrol.internal.model.ControlLook;
import org.robotui.uic.jointcontrol.internal.model.ControlModel;
import org.robotui.uic.jointcontrol.internal.model.Grid;
import org.robotui.uic.jointcontrol.internal.model.JointColumn;
import org.robotui.uic.jointcontrol.internal.model.JointDriver;
import org.robotui.uic.jointcontrol.internal.model.JointFooter;
import org.robotui.uic.jointcontrol.internal.model.JointLine;
import org.robotui.uic.jointcontrol.internal.model.JointRow;
import org.robotui.uic.jointcontrol.internal.model.Lines;
import org.robotui.uic.jointcontrol.internal.model.Sorting;

/**
 * What is seen of the view while it is shown: switch, table, the selected joint, and who drives. Display thread, but
 * for {@link #prepare}.
 */
public final class JointsSurface implements ViewSurface, TableHands.Deeds {
  private static final int ROOM_FOR_DETAIL = 240;

  /** What is to be painted. */
  private record Shown(ControlLook look, List<JointLine> lines) {}

  private final UiContext context;
  private final ControlModel model;
  private final JointDriver driver;
  private final Composite root;
  private final DriveBar bar;
  private final Headings headings;
  private final TableLook look;
  private final RowList<JointLine> list;
  private final NumberEditor editor;
  private final JointDetailPane detail;
  private final FooterLine footer;
  private volatile String words = "";
  private volatile Set<String> closed = Set.of();
  private volatile Sorting sorting = Sorting.CHAIN;
  private boolean begun;
  private volatile Shown shown;

  /** Makes the controls. */
  public JointsSurface(Composite parent, UiContext context, ControlModel model, JointDriver driver, Wishes wishes) {
    this.context = context;
    this.model = model;
    this.driver = driver;
    root = Boxes.root(parent, context.theme(), this::focus);
    bar = new DriveBar(root, context.theme(), driver, wishes, this::pressed, this::search);
    look = new TableLook(context.theme());
    headings = new Headings(root, context.theme(), this::grid, this::sort);
    list = new RowList<>(root, context.theme(), look).named("Joints").onFind(() -> bar.filter().focus())
        .onSelect(rows -> show())
        .menu(this::menu);
    list.control().setLayoutData(Boxes.fill());
    editor = new NumberEditor((Composite) list.control(), context.theme());
    detail = new JointDetailPane(root, context.theme(), driver);
    footer = new FooterLine(root, context.theme(), this::pressed);
    bar.filter().onDown(this::focus);
    shown = new Shown(model.look(), List.of());
    prepare();
    new TableHands(list, driver, this).listen();
    list.control().addListener(SWT.FocusOut, e -> root.getDisplay().asyncExec(this::watch));
    root.addListener(SWT.Resize, e -> root.getDisplay().asyncExec(this::show));
    root.addListener(SWT.Dispose, e -> driver.end("Not driving any more: the view is not shown"));
  }

  private boolean focus() {
    return list.control().forceFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Filters and sorts what is to be shown next. Any thread. */
  public void prepare() {
    ControlLook now = model.look();
    shown = new Shown(now, Lines.of(now, words, closed, sorting));
  }

  /** Shows what was prepared, and ends driving where the hands are elsewhere. What was just made has no focus yet. */
  public void refresh() {
    if (begun) {
      watch();
    }
    show();
  }

  /** Shows at once what the user has done. */
  public void again() {
    model.fresh();
    prepare();
    show();
  }

  /** Shows what was prepared. */
  public void show() {
    if (root.isDisposed()) {
      return;
    }
    begun = true;
    Shown now = shown;
    context.note(now.look().note());
    bar.show(now.look());
    look.drivable(now.look().drivable());
    look.names(list.control(), now.look().joints().byName().keySet());
    look.grid(list.control().getSize().x, now.look().drive().driving());
    headings.redraw();
    list.show(now.lines());
    list.state(now.look().state());
    empty(now);
    list.redraw();
    if (!now.look().drivable()) {
      editor.cancel();
    }
    Optional<JointRow> selected = list.selected().stream().filter(JointRow.class::isInstance).map(JointRow.class::cast)
        .findFirst()
        .filter(row -> root.getClientArea().height >= ROOM_FOR_DETAIL && StateView.showsContent(now.look().state()));
    if (detail.show(selected, now.look().drivable(), now.look().state() instanceof InputState.Live)) {
      root.layout(true, true);
    }
    footer.show(JointFooter.of(now.look().drive()), now.look().drive().robot());
  }

  private void empty(Shown now) {
    if (!now.lines().isEmpty() || !StateView.showsContent(now.look().state())) {
      list.noMessage();
    } else if (now.look().joints().byName().isEmpty()) {
      list.message(Health.NONE, "No joints", "The robot's control has no joints.");
    } else {
      list.message(Health.NONE, "No match",
          "No joint contains these words in its name, chain, owner or source. Esc clears the filter.");
    }
  }

  /** Selects a line by its key. */
  public void select(String key) {
    list.select(key);
    show();
  }

  RowList<JointLine> list() {
    return list;
  }

  DriveBar bar() {
    return bar;
  }

  NumberEditor editor() {
    return editor;
  }

  JointDetailPane detail() {
    return detail;
  }

  /** Hands that are elsewhere do not drive: what they do there is not meant for the robot. */
  private void watch() {
    if (root.isDisposed() || !model.look().drive().driving() || isWithin(root.getDisplay().getFocusControl())) {
      return;
    }
    driver.end("Not driving any more: the view lost the focus");
    again();
  }

  private boolean isWithin(Control focused) {
    for (Control control = focused; control != null; control = control.getParent()) {
      if (control == root) {
        return true;
      }
    }
    return false;
  }

  private void pressed() {
    focus();
    again();
  }

  private void pressed(JointFooter.Button button) {
    switch (button) {
      case DRIVE -> driver.confirm(false);
      case TAKE_OVER -> driver.confirm(true);
      case CANCEL -> driver.cancel();
      case RELEASE_CONTROL -> driver.giveBack();
      case RELEASE_STOP -> driver.releaseStop();
    }
    pressed();
  }

  private void search(String typed) {
    words = typed;
    again();
  }

  private void sort(Sorting next) {
    sorting = next;
    again();
  }

  private List<ViewAction> menu(List<JointLine> lines) {
    return lines.stream().filter(JointRow.class::isInstance).map(JointRow.class::cast).findFirst()
        .map(row -> List.of(
            new ViewAction("copy", "Copy row\tCtrl+C", Icon.COPY.id(), Optional.empty(),
                () -> Clipboards.copy(look.text(row))),
            new ViewAction("name", "Copy name", Icon.TEXT.id(), Optional.empty(), () -> Clipboards.copy(row.name()))))
        .orElse(List.of());
  }

  @Override
  public boolean drivable() {
    return model.look().drivable();
  }

  @Override
  public boolean jogging() {
    return model.look().drive().jog();
  }

  @Override
  public Grid grid() {
    return look.grid(list.control().getSize().x, model.look().drive().driving());
  }

  @Override
  public void fold(ChainHead head) {
    Set<String> next = new TreeSet<>(closed);
    if (!next.remove(head.chain())) {
      next.add(head.chain());
    }
    closed = Set.copyOf(next);
    again();
  }

  @Override
  public void edit(JointRow row, String first) {
    list.bounds(row.key()).ifPresent(at -> {
      Grid.Place place = grid().find(JointColumn.TARGET).or(() -> grid().find(JointColumn.POSITION))
          .orElse(new Grid.Place(0, at.width));
      double now = row.aim().map(aim -> aim.goal()).orElse(row.state().measured().position());
      editor.open(new Rectangle(at.x + place.left(), at.y, place.width(), at.height), row.measure().typed(now), first,
          row.measure()::read, value -> {
            driver.goal(row.name(), value);
            again();
          });
    });
  }

  @Override
  public void changed() {
    again();
  }
}
