package org.robotui.workbench.internal.dock;

import java.util.Arrays;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Monitor;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.layout.WindowBounds;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.WindowPlaces;

/** A window beside the main one, with views of its own. Display thread only. */
public final class ViewWindow {
  /** A window is moved in many steps, and is let go once. */
  private static final int SETTLED_MILLIS = 400;
  private static final String MARK = "robotui.view.window";

  /** Is told what the user does with a window. */
  interface Listener {
    /** It lies elsewhere. */
    void moved(ViewWindow window, WindowBounds bounds);

    /** It is to be closed; false where it stays. */
    boolean closed(ViewWindow window);
  }

  private final Shell shell;
  private final DockTree tree;
  private final Listener listener;
  private final Runnable settled = this::settled;

  ViewWindow(Shell main, Theme theme, WindowBounds bounds, DockTree.Builder builder, Listener listener) {
    this.listener = listener;
    shell = new Shell(main, SWT.SHELL_TRIM);
    shell.setData(MARK, this);
    shell.setBackground(theme.color(Role.PANEL));
    shell.setImages(main.getImages());
    shell.setLayout(new FillLayout());
    tree = new DockTree(shell, theme, builder);
    place(bounds);
    shell.addListener(SWT.Close, e -> e.doit = listener.closed(this));
    shell.addListener(SWT.Move, e -> shell.getDisplay().timerExec(SETTLED_MILLIS, settled));
    shell.addListener(SWT.Resize, e -> shell.getDisplay().timerExec(SETTLED_MILLIS, settled));
  }

  /** Whether a shell is one of these: it is no dialog. */
  public static boolean isOne(Shell shell) {
    return shell.getData(MARK) != null;
  }

  DockTree tree() {
    return tree;
  }

  Shell shell() {
    return shell;
  }

  /** Shows what it is for, and is seen. */
  void show(String title) {
    shell.setText(title);
    if (!shell.isVisible()) {
      shell.setVisible(true);
    }
  }

  /** Goes where it is to lie, unless it lies there or that is on no screen now. */
  void place(WindowBounds bounds) {
    Rectangle wanted = new Rectangle(bounds.x(), bounds.y(), bounds.width(), bounds.height());
    List<Rectangle> screens = Arrays.stream(shell.getDisplay().getMonitors()).map(Monitor::getClientArea).toList();
    if (!WindowPlaces.isSeen(wanted, screens)) {
      Rectangle main = ((Shell) shell.getParent()).getBounds();
      wanted = new Rectangle(main.x + main.width / 4, main.y + main.height / 4,
          Math.min(wanted.width, main.width), Math.min(wanted.height, main.height));
    }
    if (!shell.getBounds().equals(wanted)) {
      shell.setBounds(wanted);
    }
  }

  void dispose() {
    shell.dispose();
  }

  private void settled() {
    if (!shell.isDisposed() && shell.isVisible() && !shell.getMinimized()) {
      Rectangle at = shell.getBounds();
      listener.moved(this, new WindowBounds(at.x, at.y, Math.max(1, at.width), Math.max(1, at.height)));
    }
  }
}
