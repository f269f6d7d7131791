package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.plot.internal.model.FieldTree;

/**
 * Where traces are chosen: a field that filters the tree below it, or takes a signal as it is typed. Display thread.
 */
public final class ChooserPanel {
  /** What the panel needs of the view. */
  public interface Robot {
    List<Input.Candidate> candidates();

    Optional<FieldTree.Learned> learned(SourceId source);

    /** The name of the RUIC whose ports these are. */
    String ruic();

    /** Paths of the numbers in the newest value of a source; none before the first. */
    List<String> numbers(SourceId source);

    /** The menus of its ports. */
    SubjectMenu ports(Theme colours);

    /** Says which sources are to be asked for, to learn their fields. */
    void watch(Set<SourceId> sources);
  }

  private static final int HEAD = 44;
  private static final int FOOT = 40;
  private static final int FIELD = 28;
  private static final int BUTTON = 28;
  private static final long CALM_NANOS = 300_000_000L;

  private final Theme theme;
  private final Robot robot;
  private final Function<String, Optional<String>> add;
  private final Function<String, Optional<String>> check;
  private final FieldTree tree = new FieldTree();
  private final Composite root;
  private final PaintedCanvas ground;
  private final FilterField text;
  private final QuietButton close;
  private final FieldList list;
  private Optional<String> wrong = Optional.empty();
  private long shownNanos;

  /**
   * A panel that is not seen yet.
   *
   * @param add adds what was chosen, and says what is wrong with it
   * @param check says what is wrong with a signal that is being typed
   * @param closed is run when it is to go
   */
  ChooserPanel(Composite parent, Theme theme, Robot robot, Function<String, Optional<String>> add,
      Function<String, Optional<String>> check, Runnable closed) {
    this.check = check;
    this.theme = theme;
    this.robot = robot;
    this.add = add;
    this.root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    root.setVisible(false);
    this.text = new FilterField(root, theme, "Filter, or type a signal", words -> typed()).onEnter(this::enter);
    this.close = new QuietButton(root, theme, closed).icon(Icon.CLOSE).hint("Close the list of fields");
    this.list = new FieldList(root, theme, new Hands(), closed);
    this.ground = new PaintedCanvas(root, theme, this::paint);
    text.onDown(list::focus);
    text.setToolTipText("Part of a name, or a signal such as base./odom:linear.x or derivative(base./odom:linear.x)");
    root.addListener(SWT.Resize, e -> place());
    root.setTabList(new Control[]{text, list.control(), close});
  }

  Composite control() {
    return root;
  }

  /** Shows it, with something typed already. */
  void open(String typed) {
    root.setVisible(true);
    text.words(typed);
    text.setFocus();
    refresh(true);
  }

  /** Shows it with the fields of one source. */
  void open(SourceId source) {
    tree.open(source);
    open(source.toString());
    list.focus();
  }

  boolean isOpen() {
    return root.getVisible();
  }

  /** Has the sources asked for no more. */
  void hide() {
    root.setVisible(false);
    robot.watch(Set.of());
  }

  /** Shows what was learned, as often as one can read. */
  void refresh() {
    if (isOpen()) {
      refresh(false);
    }
  }

  private void refresh(boolean now) {
    if (now || System.nanoTime() - shownNanos > CALM_NANOS) {
      shownNanos = System.nanoTime();
      list.show(tree.rows(robot.candidates(), robot::learned, isSignal() ? "" : text.words()));
      robot.watch(tree.openSources());
    }
  }

  private boolean isSignal() {
    return text.words().indexOf(':') >= 0 || text.words().indexOf('(') >= 0;
  }

  private void typed() {
    if (!isOpen()) {
      return;
    }
    wrong = Optional.empty();
    refresh(true);
    ground.redraw();
  }

  private void enter() {
    if (isSignal()) {
      wrong = add.apply(text.words());
      if (wrong.isEmpty()) {
        text.words("");
      }
      ground.redraw();
    } else {
      list.actOn(new Hands()::act);
    }
  }

  private void place() {
    Rectangle area = root.getClientArea();
    ground.setBounds(area);
    ground.moveBelow(null);
    text.setBounds(Theme.EDGE, 2 * Theme.STEP, Math.max(0, area.width - BUTTON - 2 * Theme.EDGE - Theme.STEP), FIELD);
    close.setBounds(area.width - BUTTON - Theme.STEP - 1, 2 * Theme.STEP, BUTTON, BUTTON);
    list.control().setBounds(0, HEAD, area.width - 1, Math.max(0, area.height - HEAD - FOOT));
  }

  private void paint(GC gc, Rectangle area) {
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawLine(area.width - 1, 0, area.width - 1, area.height);
    foot(gc, area);
  }

  private void foot(GC gc, Rectangle area) {
    gc.setFont(theme.font(Face.SMALL));
    Optional<String> trouble = wrong.or(this::unreadable);
    gc.setForeground(theme.color(trouble.isPresent() ? Role.WARNING : Role.DIM));
    String words = trouble.orElse(isSignal() ? "Enter adds this signal" : "Double-click adds, drag to an axis");
    gc.drawText(TextFit.shorten(gc, words, area.width - 2 * Theme.EDGE), Theme.EDGE, area.height - FOOT + Theme.EDGE,
        true);
    ground.setToolTipText(trouble.orElse(null));
  }

  /** What is wrong with a signal that is being typed. */
  private Optional<String> unreadable() {
    if (!isSignal()) {
      return Optional.empty();
    }
    return check.apply(text.words());
  }

  private final class Hands implements FieldList.Hands {
    @Override
    public void toggle(FieldTree.Row row) {
      tree.toggle(row);
      refresh(true);
    }

    @Override
    public void add(FieldTree.Row row) {
      wrong = add.apply(String.join("\n", row.signals()));
      ground.redraw();
    }

    void act(FieldTree.Row row) {
      if (row.signals().isEmpty()) {
        toggle(row);
      } else {
        add(row);
      }
    }
  }
}
