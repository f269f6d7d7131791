package org.robotui.workbench.internal.dock;

import org.eclipse.swt.graphics.Point;

/** Nobody does anything with titles. */
final class NoGestures implements TitleLine.Gestures {
  @Override
  public void choose(int index) {
    // the line does not ask
  }

  @Override
  public void menu(int index, Point at) {
    // no menu
  }

  @Override
  public void maximize() {
    // it has its place
  }

  @Override
  public void close(int index) {
    // it stays
  }

  @Override
  public void drag(int index, Point at) {
    // it stays
  }

  @Override
  public void drop(Point at) {
    // nothing is dragged
  }
}
