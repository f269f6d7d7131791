package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Theme;

/**
 * A list or a drawing, and the details of what is selected there. The details stand below it, or beside it where there
 * is width enough; the user divides the room, for each of both anew. Without details the list has all of it. Display
 * thread.
 */
public final class DetailSplit {
  private static final int WHOLE = 100;

  private final SashForm form;
  private int besideFrom = Integer.MAX_VALUE;
  private int[] below;
  private int[] beside;
  private boolean divided;

  /**
   * A split whose details stand below the list. The first of its {@link #parts} is the list, the second the details.
   *
   * @param parent the parent, with a grid layout: the split takes all the room that others leave
   * @param theme colours
   * @param share how much of the height the list has, in percent
   */
  public DetailSplit(Composite parent, Theme theme, int share) {
    form = Boxes.split(parent, theme, SWT.VERTICAL);
    below = shares(share);
    beside = below;
    form.setLayoutData(Boxes.fill());
    form.addListener(SWT.Resize, e -> arrange());
  }

  /**
   * Has the details stand beside the list where there is room.
   *
   * @param width from which width on
   * @param share how much of the width the list has, in percent
   * @return this
   */
  public DetailSplit besideFrom(int width, int share) {
    besideFrom = width;
    beside = shares(share);
    return this;
  }

  /**
   * Divides by a thin line, for parts that have an edge of their own.
   *
   * @return this
   */
  public DetailSplit thin() {
    form.setSashWidth(1);
    return this;
  }

  /**
   * The parent of both parts.
   *
   * @return to be given first the list, then the details
   */
  public Composite parts() {
    return form;
  }

  /**
   * Whether the details are shown.
   *
   * @return true until they are hidden for the first time
   */
  public boolean isDetailed() {
    return form.getMaximizedControl() == null;
  }

  /**
   * Shows the details or hides them. Both parts have been made.
   *
   * @param seen whether they are shown
   * @return whether that has changed
   */
  public boolean detail(boolean seen) {
    arrange();
    if (seen == isDetailed()) {
      return false;
    }
    Control alone = seen ? null : form.getChildren()[0];
    form.setMaximizedControl(alone);
    return true;
  }

  private static int[] shares(int list) {
    return new int[]{list, WHOLE - list};
  }

  private void arrange() {
    boolean before = form.getOrientation() == SWT.HORIZONTAL;
    boolean wanted = form.getSize().x >= besideFrom;
    if (divided && before == wanted) {
      return;
    }
    if (divided && before) {
      beside = form.getWeights();
    } else if (divided) {
      below = form.getWeights();
    }
    divided = true;
    form.setOrientation(wanted ? SWT.HORIZONTAL : SWT.VERTICAL);
    form.setWeights(wanted ? beside : below);
  }
}
