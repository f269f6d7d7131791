package org.robotui.ui.control;

import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.Face;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A field for words to search or filter by, with a button that clears it. Esc clears, arrow down goes on to the list,
 * enter may choose. Display thread only.
 */
public final class FilterField extends Canvas {
  private static final int HEIGHT = 26;
  private static final int WIDTH = 200;
  private static final int CORNER = 10;
  /** The key of SWT for a style of GTK: this field shows the focus at its own edge, not by a frame inside it. */
  private static final String LOOK = "org.eclipse.swt.internal.gtk.css";

  private final Theme theme;
  private final Text text;
  private final QuietButton clear;
  private final Consumer<String> changed;
  private Runnable down = () -> {};
  private Runnable enter = () -> {};

  /**
   * An empty field.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param placeholder what it says while it is empty, also its name for screen readers
   * @param changed is given the words each time they change
   */
  public FilterField(Composite parent, Theme theme, String placeholder, Consumer<String> changed) {
    super(parent, SWT.DOUBLE_BUFFERED | SWT.NO_BACKGROUND);
    this.theme = theme;
    this.changed = changed;
    setBackground(parent.getBackground());
    text = new Text(this, SWT.SINGLE);
    text.setMessage(placeholder);
    text.setToolTipText(placeholder + "; Esc clears");
    text.setFont(theme.font(Face.BODY));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    text.setData(LOOK, "entry:focus { box-shadow: none; border-color: transparent; outline-style: none; }");
    Spoken.name(text, placeholder);
    clear = new QuietButton(this, theme, this::clear).icon(Icon.CLOSE).hint("Clear");
    clear.setBackground(theme.color(Role.GROUND));
    clear.setVisible(false);
    listen();
  }

  /** Puts the cursor into it and selects what is there. For Ctrl+F. */
  public void focus() {
    text.setFocus();
    text.selectAll();
  }

  /**
   * The words.
   *
   * @return as typed
   */
  public String words() {
    return text.getText();
  }

  /**
   * Sets the words, and tells as if the user had typed them.
   *
   * @param words the words
   */
  public void words(String words) {
    text.setText(words);
    text.setSelection(words.length());
  }

  /**
   * What the arrow down key does.
   *
   * @param action for example focus of the list
   * @return this
   */
  public FilterField onDown(Runnable action) {
    down = action;
    return this;
  }

  /**
   * What the enter key does.
   *
   * @param action for example the choice of what is found
   * @return this
   */
  public FilterField onEnter(Runnable action) {
    enter = action;
    return this;
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean forget) {
    checkWidget();
    return new Point(widthHint == SWT.DEFAULT ? WIDTH : widthHint, heightHint == SWT.DEFAULT ? HEIGHT : heightHint);
  }

  @Override
  public boolean setFocus() {
    return text.setFocus();
  }

  private void clear() {
    text.setText("");
    text.setFocus();
  }

  private void listen() {
    addListener(SWT.Paint, e -> paint(e.gc, getClientArea()));
    addListener(SWT.Resize, e -> arrange());
    addListener(SWT.MouseDown, e -> text.setFocus());
    text.addListener(SWT.Modify, e -> modified());
    text.addListener(SWT.KeyDown, this::key);
    text.addListener(SWT.FocusIn, e -> redraw());
    text.addListener(SWT.FocusOut, e -> redraw());
    text.addListener(SWT.DefaultSelection, e -> enter.run());
  }

  private void modified() {
    clear.setVisible(!text.getText().isEmpty());
    changed.accept(text.getText());
  }

  private void key(Event event) {
    switch (event.keyCode) {
      case SWT.ESC -> text.setText("");
      case SWT.ARROW_DOWN -> down.run();
      default -> {}
    }
  }

  private void arrange() {
    Point size = getSize();
    int line = text.computeSize(SWT.DEFAULT, SWT.DEFAULT).y;
    int button = size.y - Theme.STEP;
    text.setBounds(2 * Theme.STEP, (size.y - line) / 2, Math.max(0, size.x - button - 3 * Theme.STEP), line);
    clear.setBounds(size.x - button - 2, 2, button, button);
  }

  private void paint(GC gc, Rectangle area) {
    gc.setBackground(getBackground());
    gc.fillRectangle(area);
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.color(Role.GROUND));
    gc.fillRoundRectangle(0, 0, area.width - 1, area.height - 1, CORNER, CORNER);
    gc.setForeground(theme.color(text.isFocusControl() ? Role.ACCENT : Role.LINE));
    gc.setLineWidth(1);
    gc.drawRoundRectangle(0, 0, area.width - 1, area.height - 1, CORNER, CORNER);
  }
}
