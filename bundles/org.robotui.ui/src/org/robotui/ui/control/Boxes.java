package org.robotui.ui.control;

import java.util.function.BooleanSupplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * Containers in the theme's colours, and the places of what stands in them. They are no plain composites, which style
 * sheets would colour. Display thread.
 */
public final class Boxes {
  /** By this the platform leaves a widget out when it gives all of a kind one colour. */
  private static final String OWN_COLOURS = "org.eclipse.e4.ui.css.disabled";
  private static final int SASH = 4;

  private Boxes() {}

  private static final class Box extends Composite {
    private final BooleanSupplier focus;
    private boolean ending;

    Box(Composite parent, Theme theme, GridLayout layout, BooleanSupplier focus) {
      super(parent, SWT.NONE);
      this.focus = focus;
      setBackground(theme.color(Role.PANEL));
      setLayout(layout);
      addListener(SWT.Dispose, e -> ending = true);
    }

    /** While it is disposed, its parts go one by one, and each that had the focus wants to give it back. */
    @Override
    public boolean setFocus() {
      return !ending && (focus.getAsBoolean() || super.setFocus());
    }
  }

  private static final class Splitter extends SashForm {
    Splitter(Composite parent, int style) {
      super(parent, style | SWT.SMOOTH);
    }
  }

  /**
   * Keeps the colours that a control of the platform is given: style sheets leave it and what is in it out.
   *
   * @param <C> the type of the control
   * @param control any
   * @return the control
   */
  public static <C extends Control> C ownColours(C control) {
    control.setData(OWN_COLOURS, Boolean.TRUE);
    return control;
  }

  /**
   * A container without any room between or around its parts.
   *
   * @param parent the parent
   * @param theme colours
   * @param columns how many parts stand beside each other
   * @return the container, with a {@link GridLayout}
   */
  public static Composite panel(Composite parent, Theme theme, int columns) {
    return new Box(parent, theme, grid(columns), () -> false);
  }

  /**
   * A panel with one column that gives the focus to the part where the work is, not to the first button above it.
   *
   * @param parent the parent
   * @param theme colours
   * @param focus gives the focus to that part, and says whether it has it
   * @return the container
   */
  public static Composite root(Composite parent, Theme theme, BooleanSupplier focus) {
    return new Box(parent, theme, grid(1), focus);
  }

  /**
   * A line of controls with a little room around and between them, as wide as its parent.
   *
   * @param parent the parent, with a {@link GridLayout}
   * @param theme colours
   * @param columns how many controls
   * @return the line
   */
  public static Composite bar(Composite parent, Theme theme, int columns) {
    Composite bar = panel(parent, theme, columns);
    GridLayout layout = (GridLayout) bar.getLayout();
    layout.marginWidth = 2 * Theme.STEP;
    layout.marginHeight = Theme.STEP;
    layout.horizontalSpacing = Theme.STEP;
    bar.setLayoutData(line());
    return bar;
  }

  /**
   * A container with room at its edges and between the parts that stand beside each other.
   *
   * @param parent the parent
   * @param theme colours
   * @param columns how many parts stand beside each other
   * @param marginWidth at the left and right, in points
   * @param marginHeight above and below, in points
   * @return the container, with a {@link GridLayout}
   */
  public static Composite inset(Composite parent, Theme theme, int columns, int marginWidth, int marginHeight) {
    Composite box = panel(parent, theme, columns);
    GridLayout layout = (GridLayout) box.getLayout();
    layout.marginWidth = marginWidth;
    layout.marginHeight = marginHeight;
    layout.horizontalSpacing = 2 * Theme.STEP;
    return box;
  }

  /**
   * A thin line between what is above and below.
   *
   * @param parent the parent, with a {@link GridLayout}
   * @param theme colours
   * @return the line
   */
  public static Composite rule(Composite parent, Theme theme) {
    Composite rule = panel(parent, theme, 1);
    rule.setBackground(theme.color(Role.LINE));
    rule.setLayoutData(line(1));
    return rule;
  }

  /**
   * A container that the user divides.
   *
   * @param parent the parent
   * @param theme colours
   * @param style {@link SWT#HORIZONTAL} for parts beside each other, {@link SWT#VERTICAL} for one above the other
   * @return the container, with a sash that the pointer can grasp
   */
  public static SashForm split(Composite parent, Theme theme, int style) {
    SashForm form = new Splitter(parent, style);
    form.setBackground(theme.color(Role.GROUND));
    form.setSashWidth(SASH);
    return form;
  }

  /**
   * A layout without any room between or around the parts.
   *
   * @param columns how many parts stand beside each other
   * @return the layout
   */
  public static GridLayout grid(int columns) {
    GridLayout layout = new GridLayout(columns, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.horizontalSpacing = 0;
    layout.verticalSpacing = 0;
    return layout;
  }

  /**
   * A place as wide as the parent and as high as need be.
   *
   * @return the place
   */
  public static GridData line() {
    return new GridData(SWT.FILL, SWT.TOP, true, false);
  }

  /**
   * A place as wide as the parent.
   *
   * @param height in points
   * @return the place
   */
  public static GridData line(int height) {
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.heightHint = height;
    return data;
  }

  /**
   * A place that takes all the room there is.
   *
   * @return the place
   */
  public static GridData fill() {
    return new GridData(SWT.FILL, SWT.FILL, true, true);
  }

  /**
   * A place in a bar, as wide as need be.
   *
   * @return the place
   */
  public static GridData middle() {
    return new GridData(SWT.BEGINNING, SWT.CENTER, false, false);
  }

  /**
   * A place at the right end of a bar, which takes the room that is left.
   *
   * @param width of the control, in points
   * @return the place
   */
  public static GridData end(int width) {
    GridData data = new GridData(SWT.END, SWT.CENTER, true, false);
    data.widthHint = width;
    return data;
  }

  /**
   * Shows a control or takes it out of the layout.
   *
   * @param control what has a {@link GridData}
   * @param wanted whether it is to be seen
   * @return whether that changed anything, so that the parent is to be laid out again
   */
  public static boolean seen(Control control, boolean wanted) {
    GridData data = (GridData) control.getLayoutData();
    boolean changed = data.exclude == wanted;
    data.exclude = !wanted;
    if (changed) {
      control.setVisible(wanted);
    }
    return changed;
  }
}
