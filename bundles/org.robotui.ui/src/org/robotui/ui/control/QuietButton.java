package org.robotui.ui.control;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleControlAdapter;
import org.eclipse.swt.accessibility.AccessibleControlEvent;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Icons;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;

/**
 * A button without a border: text, an icon, or both. It may be switched (a toggle), and filled where it is the one
 * thing to press. Enter and space press it. Display thread only.
 */
public final class QuietButton extends Canvas {
  private static final int HEIGHT = 28;
  private static final int ICON_ONLY_PADDING = 6;
  private static final int CORNER = 12;

  private final Theme theme;
  private final Runnable pressed;
  private Optional<Icon> icon = Optional.empty();
  private Optional<Role> filled = Optional.empty();
  private String text = "";
  private boolean checked;
  private boolean hot;
  private boolean down;

  /**
   * A button on the ground of its parent.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param pressed is run on the display thread each time it is pressed
   */
  public QuietButton(Composite parent, Theme theme, Runnable pressed) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    this.pressed = pressed;
    setBackground(parent.getBackground());
    setFont(theme.font(Face.BODY));
    addPaintListener(e -> paint(e.gc, getClientArea()));
    listen();
    describe();
  }

  /**
   * Sets the text.
   *
   * @param words a short imperative; empty for an icon alone
   * @return this
   */
  public QuietButton text(String words) {
    if (!text.equals(words)) {
      text = words;
      redraw();
    }
    return this;
  }

  /**
   * Sets the icon.
   *
   * @param drawing the icon
   * @return this
   */
  public QuietButton icon(Icon drawing) {
    icon = Optional.of(drawing);
    redraw();
    return this;
  }

  /**
   * Fills it with a colour.
   *
   * @param role for example {@link Role#BAD} for a stop
   * @return this
   */
  public QuietButton fill(Role role) {
    filled = Optional.of(role);
    setFont(theme.font(Face.BODY_STRONG));
    redraw();
    return this;
  }

  /**
   * Sets the name for tooltips and screen readers.
   *
   * @param hint what it does
   * @return this
   */
  public QuietButton hint(String hint) {
    setToolTipText(hint);
    return this;
  }

  /**
   * Shows it as on or off.
   *
   * @param on whether it is on
   * @return this
   */
  public QuietButton checked(boolean on) {
    if (checked != on) {
      checked = on;
      redraw();
    }
    return this;
  }

  /**
   * Whether it is shown as on.
   *
   * @return false at the beginning
   */
  public boolean isChecked() {
    return checked;
  }

  /** Presses it, as the mouse would. */
  public void press() {
    if (isEnabled()) {
      pressed.run();
    }
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    checkWidget();
    return new Point(
        widthHint == SWT.DEFAULT ? contentWidth() + 2 * padding() : widthHint,
        heightHint == SWT.DEFAULT ? HEIGHT : heightHint);
  }

  @Override
  public void setEnabled(boolean enabled) {
    super.setEnabled(enabled);
    redraw();
  }

  private int padding() {
    return text.isEmpty() ? ICON_ONLY_PADDING : Theme.EDGE;
  }

  private int contentWidth() {
    GC gc = new GC(this);
    gc.setFont(getFont());
    int width = text.isEmpty() ? 0 : gc.textExtent(text).x;
    gc.dispose();
    int gap = icon.isPresent() && !text.isEmpty() ? 2 * Theme.STEP : 0;
    return width + gap + (icon.isPresent() ? Icons.SIZE : 0);
  }

  /**
   * In the middle; an icon stays where it is in the buttons above and below when there is no room for all of the text.
   */
  static int start(int width, int content, boolean hasIcon) {
    return content > width && hasIcon ? Theme.EDGE : Math.max(Theme.STEP, (width - content) / 2);
  }

  private void paint(GC gc, Rectangle area) {
    gc.setAntialias(SWT.ON);
    paintGround(gc, area);
    gc.setForeground(ink());
    int x = start(area.width, contentWidth(), icon.isPresent());
    if (icon.isPresent()) {
      Icons.paint(gc, icon.get(), x, (area.height - Icons.SIZE) / 2, Icons.SIZE);
      x += Icons.SIZE + 2 * Theme.STEP;
    }
    gc.setFont(getFont());
    String fitting = contentWidth() > area.width ? TextFit.shorten(gc, text, area.width - x - Theme.STEP) : text;
    gc.drawText(fitting, x, (area.height - gc.textExtent(text).y) / 2, true);
    if (isFocusControl()) {
      gc.setForeground(theme.color(Role.ACCENT));
      gc.setLineWidth(1);
      gc.drawRoundRectangle(0, 0, area.width - 1, area.height - 1, CORNER, CORNER);
    }
  }

  private void paintGround(GC gc, Rectangle area) {
    Optional<Color> ground = ground();
    if (ground.isPresent()) {
      gc.setBackground(ground.get());
      gc.fillRoundRectangle(0, 0, area.width, area.height, CORNER, CORNER);
    }
  }

  private Optional<Color> ground() {
    if (filled.isPresent() && isEnabled()) {
      return Optional.of(theme.mix(Role.TEXT, filled.get(), down ? 0.25 : hot ? 0.12 : 0));
    }
    if (checked) {
      return Optional.of(theme.mix(Role.ACCENT, Role.PANEL, hot ? 0.3 : 0.22));
    }
    return hot && isEnabled() ? Optional.of(theme.mix(Role.TEXT, Role.PANEL, down ? 0.18 : 0.1)) : Optional.empty();
  }

  private Color ink() {
    if (!isEnabled()) {
      return theme.mix(Role.DIM, Role.PANEL, 0.6);
    }
    return filled.map(theme::on).orElse(theme.color(checked ? Role.ACCENT : hot ? Role.TEXT : Role.DIM));
  }

  private void listen() {
    addListener(SWT.MouseEnter, e -> state(true, down));
    addListener(SWT.MouseExit, e -> state(false, false));
    addListener(SWT.MouseDown, e -> state(hot, e.button == 1));
    addListener(SWT.MouseUp, this::released);
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.KeyDown, this::key);
    addListener(SWT.Traverse, e -> e.doit = e.detail != SWT.TRAVERSE_RETURN);
  }

  private void state(boolean isHot, boolean isDown) {
    hot = isHot;
    down = isDown;
    redraw();
  }

  private void released(Event event) {
    boolean hit = down && getClientArea().contains(event.x, event.y);
    state(hot, false);
    if (hit) {
      press();
    }
  }

  private void key(Event event) {
    if (event.character == ' ' || event.character == SWT.CR) {
      press();
    }
  }

  private void describe() {
    getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = text.isEmpty() ? getToolTipText() : text;
      }
    });
    getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = ACC.ROLE_PUSHBUTTON;
      }
    });
  }
}
