package org.robotui.ui.diagram;

/**
 * What the user wants of a view that draws a diagram. Display thread.
 *
 * @param <A> what can be asked for
 */
public interface DiagramWishes<A> {
  /**
   * What is asked for now.
   *
   * @return the last that was asked for
   */
  A asked();

  /**
   * Asks for something else.
   *
   * @param next what
   */
  void ask(A next);

  /**
   * Says how wide letters are here.
   *
   * @param exact by which boxes are laid out
   */
  void widths(TextWidths exact);
}
