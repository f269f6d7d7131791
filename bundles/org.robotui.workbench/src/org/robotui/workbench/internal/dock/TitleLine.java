package org.robotui.workbench.internal.dock;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleControlAdapter;
import org.eclipse.swt.accessibility.AccessibleControlEvent;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.Font;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;

/**
 * The line above views: their titles, the actions of the one that is seen, and its note. What there is no room for,
 * titles and actions, is in a menu; the title of the view that is seen always stands there. Display thread only.
 */
final class TitleLine extends Composite {
  /** Is told what the user does with titles. */
  interface Gestures {
    /** A view is to be seen. */
    void choose(int index);

    /** The menu of a view is wanted, at a point of the display. */
    void menu(int index, Point at);

    /** The view that is seen is to have the whole window, or its place again. */
    void maximize();

    /** A view is to be closed. */
    void close(int index);

    /** A view is dragged over a point of the display. */
    void drag(int index, Point at);

    /** What is dragged is let go at a point of the display. */
    void drop(Point at);
  }

  static final int HEIGHT = 30;

  private static final int BUTTON = 26;
  private static final int GAP = 4 * Theme.STEP;
  /** A hand that presses is never quite still. */
  private static final int DRAG_PIXELS = 6;

  private final Theme theme;
  private final List<String> titles;
  private final Gestures gestures;
  private final List<ActionButton> buttons = new ArrayList<>();
  private final QuietButton more;
  private final QuietButton restore;
  private TitleRow row = new TitleRow(List.of(), 0);
  private ActionRow actionRow = new ActionRow(List.of(), List.of());
  private int shown;
  private String note = "";
  private boolean focused;
  private Optional<Press> pressed = Optional.empty();

  /** Where a title was pressed, and whether it is dragged since. */
  private record Press(int index, int x, int y, boolean drags) {}

  /** An action and its button. */
  private record ActionButton(ViewAction action, QuietButton button) {}

  TitleLine(Composite parent, Theme theme, List<String> titles, Gestures gestures) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    this.titles = titles;
    this.gestures = gestures;
    setBackground(theme.color(Role.TITLE));
    more = new QuietButton(this, theme, this::openMore).icon(Icon.MORE).hint("More");
    more.setVisible(false);
    restore = new QuietButton(this, theme, gestures::maximize).icon(Icon.RESTORE).hint("Restore (double-click)");
    restore.setVisible(false);
    addPaintListener(e -> paint(e.gc));
    addListener(SWT.MouseDown, this::press);
    addListener(SWT.MouseMove, this::drag);
    addListener(SWT.MouseUp, this::release);
    addListener(SWT.MouseDoubleClick, e -> gestures.maximize());
    addListener(SWT.MenuDetect, e -> gestures.menu(indexAt(toControl(e.x, e.y).x), new Point(e.x, e.y)));
    addListener(SWT.KeyDown, this::key);
    addListener(SWT.Resize, e -> place());
    addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    describe();
  }

  void show(int index) {
    shown = index;
    place();
    redraw();
  }

  /** Whether the view that is seen has the whole window. */
  void maximized(boolean now) {
    restore.setVisible(now);
    place();
    redraw();
  }

  /** Whether the keys go to the view that is seen: its title is marked. */
  void focused(boolean now) {
    if (focused != now) {
      focused = now;
      redraw();
    }
  }

  boolean isFocused() {
    return focused;
  }

  void note(String text) {
    if (!note.equals(text)) {
      note = text;
      redraw();
    }
  }

  String note() {
    return note;
  }

  /** Makes the buttons anew only where the actions are others: one that is being pressed must not go. */
  void actions(List<ViewAction> actions) {
    if (actions.equals(buttons.stream().map(ActionButton::action).toList())) {
      return;
    }
    buttons.forEach(b -> b.button().dispose());
    buttons.clear();
    for (ViewAction action : actions) {
      QuietButton button = new QuietButton(this, theme, () -> run(action)).hint(action.label());
      Icon.find(action.icon()).ifPresentOrElse(button::icon, () -> button.text(action.label()));
      buttons.add(new ActionButton(action, button));
    }
    checks();
    place();
    redraw();
  }

  /** Asks the switched actions whether they are on. */
  void checks() {
    buttons.forEach(b -> b.action().checked().ifPresent(on -> b.button().checked(on.getAsBoolean())));
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    return new Point(widthHint == SWT.DEFAULT ? 100 : widthHint, HEIGHT);
  }

  private void run(ViewAction action) {
    action.run().run();
    checks();
  }

  private void place() {
    int right = getSize().x - Theme.STEP;
    if (restore.getVisible()) {
      right -= BUTTON;
      restore.setBounds(right, (HEIGHT - BUTTON) / 2, BUTTON, BUTTON);
    }
    int[] sizes = buttons.stream().mapToInt(b -> b.button().computeSize(SWT.DEFAULT, BUTTON).x).toArray();
    int[] widths = widths();
    int title = Theme.EDGE + widths[shown] + (titles.size() > 1 ? moreWidth() : 0);
    actionRow = ActionRow.of(sizes, right - title);
    if (titles.size() == 1 && !actionRow.others().isEmpty()) {
      actionRow = ActionRow.of(sizes, right - title - moreWidth());
    }
    for (int i = 0; i < sizes.length; i++) {
      buttons.get(i).button().setVisible(actionRow.seen().contains(i));
    }
    for (int i : actionRow.seen().reversed()) {
      right -= sizes[i];
      buttons.get(i).button().setBounds(right, (HEIGHT - BUTTON) / 2, sizes[i], BUTTON);
    }
    placeTitles(widths);
  }

  private int moreWidth() {
    return more.computeSize(SWT.DEFAULT, BUTTON).x;
  }

  private void placeTitles(int[] widths) {
    int width = moreWidth();
    int room = actionsLeft() - (actionRow.others().isEmpty() ? 0 : width);
    row = TitleRow.of(widths, shown, Theme.EDGE, room, actionRow.others().isEmpty() ? width : 0);
    more.setVisible(row.places().size() < titles.size() || !actionRow.others().isEmpty());
    more.setBounds(row.right() - 2 * Theme.STEP, (HEIGHT - BUTTON) / 2, width, BUTTON);
  }

  /** As they are painted, each with the room to the next. */
  private int[] widths() {
    GC gc = new GC(this);
    int[] widths = IntStream.range(0, titles.size()).map(i -> {
      gc.setFont(font(i));
      return gc.textExtent(titles.get(i)).x + GAP;
    }).toArray();
    gc.dispose();
    return widths;
  }

  private Font font(int index) {
    return theme.font(index == shown ? Face.BODY_STRONG : Face.BODY);
  }

  private void openMore() {
    PopupMenu menu = new PopupMenu(more);
    row.others(titles.size()).forEach(index -> menu.push(titles.get(index), () -> choose(index)));
    actionRow.others().forEach(index -> menu.action(buttons.get(index).action()));
    menu.openBelow(more);
  }

  private int actionsLeft() {
    return actionRow.seen().isEmpty()
        ? getSize().x - Theme.EDGE + 2 * Theme.STEP - (restore.getVisible() ? BUTTON : 0)
        : buttons.get(actionRow.seen().getFirst()).button().getLocation().x;
  }

  private void paint(GC gc) {
    gc.setTextAntialias(SWT.ON);
    gc.setForeground(theme.color(Role.LINE));
    gc.drawLine(0, HEIGHT - 1, getSize().x, HEIGHT - 1);
    row.places().forEach(place -> paintTitle(gc, place));
    paintNote(gc, row.right() + (more.getVisible() ? more.getSize().x : 0));
  }

  private void paintTitle(GC gc, TitleRow.Place place) {
    boolean on = place.index() == shown;
    String title = titles.get(place.index());
    gc.setFont(font(place.index()));
    gc.setForeground(theme.color(on ? Role.TEXT : Role.DIM));
    Point size = gc.textExtent(title);
    gc.drawText(title, place.left(), (HEIGHT - size.y) / 2, true);
    if (on && (focused || titles.size() > 1)) {
      gc.setBackground(focused ? theme.color(Role.ACCENT) : theme.mix(Role.DIM, Role.TITLE, 0.5));
      gc.fillRectangle(place.left(), HEIGHT - 2, size.x, 2);
    }
  }

  private void paintNote(GC gc, int left) {
    gc.setFont(theme.font(Face.SMALL));
    gc.setForeground(theme.color(Role.DIM));
    int right = actionsLeft() - 2 * Theme.STEP;
    String text = TextFit.shorten(gc, note, right - left);
    Point size = gc.textExtent(text);
    gc.drawText(text, right - size.x, (HEIGHT - size.y) / 2, true);
  }

  private void press(Event event) {
    if (event.button == 1) {
      pressed = Optional.of(new Press(indexAt(event.x), event.x, event.y, false));
      row.at(event.x).ifPresent(this::choose);
    } else if (event.button == 2) {
      row.at(event.x).ifPresent(gestures::close);
    }
  }

  /** The title at a place, else that of the view that is seen: the whole line is its handle. */
  private int indexAt(int x) {
    return row.at(x).orElse(shown);
  }

  private void drag(Event event) {
    pressed = pressed.filter(p -> (event.stateMask & SWT.BUTTON1) != 0).map(p -> new Press(p.index(), p.x(), p.y(),
        p.drags() || Math.hypot(event.x - p.x(), event.y - p.y()) > DRAG_PIXELS));
    pressed.filter(Press::drags).ifPresent(p -> gestures.drag(p.index(), toDisplay(event.x, event.y)));
  }

  private void release(Event event) {
    Optional<Press> dragged = pressed.filter(Press::drags);
    pressed = Optional.empty();
    dragged.ifPresent(p -> gestures.drop(toDisplay(event.x, event.y)));
  }

  String titleOf(int index) {
    return titles.get(index);
  }

  /** Before which title something that is dropped at a place comes. */
  int indexBefore(int x) {
    return row.places().stream().filter(place -> x < (place.left() + place.right()) / 2).findFirst()
        .map(TitleRow.Place::index).orElse(titles.size());
  }

  /** Keys go where the user looks; who walks by key stays in the line. */
  private void choose(int index) {
    gestures.choose(index);
    getParent().setFocus();
  }

  private void key(Event event) {
    if (event.keyCode == SWT.ARROW_RIGHT && shown + 1 < titles.size()) {
      gestures.choose(shown + 1);
    } else if (event.keyCode == SWT.ARROW_LEFT && shown > 0) {
      gestures.choose(shown - 1);
    }
  }

  private void describe() {
    getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = titles.get(shown);
      }
    });
    getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = ACC.ROLE_TABFOLDER;
      }
    });
  }
}
