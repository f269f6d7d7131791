package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.accessibility.ACC;
import org.eclipse.swt.accessibility.AccessibleAdapter;
import org.eclipse.swt.accessibility.AccessibleControlAdapter;
import org.eclipse.swt.accessibility.AccessibleControlEvent;
import org.eclipse.swt.accessibility.AccessibleEvent;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** The title of a menu in the top bar. Display thread only. */
final class MenuButton extends Canvas {
  private static final int HEIGHT = 28;

  private final Theme theme;
  private final TopBar.MenuTitle title;
  private boolean hot;

  MenuButton(Composite parent, Theme theme, TopBar.MenuTitle title, TopBar.Actions actions) {
    super(parent, SWT.DOUBLE_BUFFERED);
    this.theme = theme;
    this.title = title;
    setBackground(parent.getBackground());
    addPaintListener(e -> paint(e.gc));
    addListener(SWT.MouseEnter, e -> hot(true));
    addListener(SWT.MouseExit, e -> hot(false));
    addListener(SWT.FocusIn, e -> redraw());
    addListener(SWT.FocusOut, e -> redraw());
    addListener(SWT.MouseDown, e -> actions.menu(title.id(), this));
    addListener(SWT.KeyDown, e -> key(e, actions));
    addListener(SWT.Traverse, e -> e.doit = e.detail != SWT.TRAVERSE_RETURN);
    describe();
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    GC gc = new GC(this);
    gc.setFont(theme.font(Face.BODY));
    int width = gc.textExtent(title.label()).x + 4 * Theme.STEP;
    gc.dispose();
    return new Point(width, HEIGHT);
  }

  private void key(Event event, TopBar.Actions actions) {
    if (event.character == ' ' || event.character == SWT.CR || event.keyCode == SWT.ARROW_DOWN) {
      actions.menu(title.id(), this);
    }
  }

  private void hot(boolean now) {
    hot = now;
    redraw();
  }

  private void paint(GC gc) {
    Point size = getSize();
    gc.setAntialias(SWT.ON);
    if (hot || isFocusControl()) {
      gc.setBackground(theme.mix(Role.TEXT, Role.GROUND, 0.1));
      gc.fillRoundRectangle(0, 0, size.x, size.y, 10, 10);
    }
    gc.setFont(theme.font(Face.BODY));
    gc.setForeground(theme.color(hot ? Role.TEXT : Role.DIM));
    gc.drawText(title.label(), 2 * Theme.STEP, (size.y - gc.textExtent(title.label()).y) / 2, true);
  }

  private void describe() {
    getAccessible().addAccessibleListener(new AccessibleAdapter() {
      @Override
      public void getName(AccessibleEvent e) {
        e.result = title.label();
      }
    });
    getAccessible().addAccessibleControlListener(new AccessibleControlAdapter() {
      @Override
      public void getRole(AccessibleControlEvent e) {
        e.detail = ACC.ROLE_MENUITEM;
      }
    });
  }
}
