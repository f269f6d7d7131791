package org.robotui.testkit;

import java.util.function.BiConsumer;
import java.util.function.Function;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;

/** A window that shows a view in all its states side by side, for a person to look at. Display thread. */
public final class GalleryWindow {
  private static final int WIDTH = 1600;
  private static final int HEIGHT = 1000;

  private final Shell shell;

  /**
   * An empty window.
   *
   * @param display where it is shown
   * @param ground what is seen between the cells
   */
  public GalleryWindow(Display display, Color ground) {
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setBounds(0, 0, WIDTH, HEIGHT);
    shell.setBackground(ground);
  }

  /**
   * Makes a window in a look, has it filled, and shows it until it is closed.
   *
   * @param <T> what a look is
   * @param looks finds the look that was asked for
   * @param ground what is seen between the cells
   * @param fill puts the states in
   */
  public static <T> void show(Function<Display, T> looks, Function<T, Color> ground,
      BiConsumer<GalleryWindow, T> fill) {
    Display display = new Display();
    T look = looks.apply(display);
    GalleryWindow window = new GalleryWindow(display, ground.apply(look));
    fill.accept(window, look);
    window.show();
  }

  /**
   * A place for one state.
   *
   * @param x points from the left
   * @param y points from the top
   * @param width in points
   * @param height in points
   * @return an empty place, which its one child fills
   */
  public Composite cell(int x, int y, int width, int height) {
    Composite cell = new Composite(shell, SWT.NONE);
    cell.setBounds(x, y, width, height);
    cell.setLayout(new FillLayout());
    return cell;
  }

  /**
   * A place that was made before, to press something in it.
   *
   * @param number of the place, the first is 0
   * @return the place
   */
  public Control made(int number) {
    return shell.getChildren()[number];
  }

  /** Opens the window, for what has to be seen before it is filled. */
  public void open() {
    shell.open();
  }

  /** Shows the window until it is closed. */
  public void show() {
    shell.open();
    while (!shell.isDisposed()) {
      if (!shell.getDisplay().readAndDispatch()) {
        shell.getDisplay().sleep();
      }
    }
  }
}
