package org.robotui.ui.display;

import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;

/** A view with the list of what it shows at its left, where that is open and there is room for it. Display thread. */
public final class ListedView {
  private static final int LIST_WIDTH = 264;
  private static final int LEAST_CONTENT = 240;

  private final BooleanSupplier open;
  private final Composite root;
  private final DisplayPane pane;
  private final Control content;

  /**
   * A view.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param host of the list
   * @param open whether the list is to be seen
   * @param made makes what is beside the list, in the composite that it is given
   */
  public ListedView(Composite parent, Theme theme, DisplayPane.Host host, BooleanSupplier open,
      Function<Composite, ? extends Control> made) {
    this.open = open;
    root = Boxes.root(parent, theme, this::focus);
    ((GridLayout) root.getLayout()).numColumns = 2;
    pane = new DisplayPane(root, theme, host);
    GridData side = new GridData(SWT.FILL, SWT.FILL, false, true);
    side.widthHint = LIST_WIDTH;
    pane.control().setLayoutData(side);
    content = made.apply(root);
    content.setLayoutData(Boxes.fill());
    root.addListener(SWT.Resize, e -> arrange());
    arrange();
  }

  /**
   * What stands in the window.
   *
   * @return the control
   */
  public Control control() {
    return root;
  }

  /**
   * The list.
   *
   * @return at the left
   */
  public DisplayPane pane() {
    return pane;
  }

  /** Opens or closes the list, as is wanted now. */
  public void arrange() {
    if (Boxes.seen(pane.control(), listSeen())) {
      root.layout();
    }
  }

  /**
   * Whether the list is to be seen: it may be open, and yet there is no room for it beside the content.
   *
   * @return whether it is
   */
  public boolean listSeen() {
    return open.getAsBoolean() && hasRoom(root.getSize().x);
  }

  static boolean hasRoom(int width) {
    return width == 0 || width >= LIST_WIDTH + LEAST_CONTENT;
  }

  private boolean focus() {
    return content.setFocus();
  }
}
