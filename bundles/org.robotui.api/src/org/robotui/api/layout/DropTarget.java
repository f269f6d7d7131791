package org.robotui.api.layout;

/** Where a view is to lie. A view that is named here lies somewhere; where it does not, nothing is moved. */
public sealed interface DropTarget {
  /**
   * Among the tabs of another view.
   *
   * @param view the other view
   * @param index before which of those tabs, from 0; behind all of them where it is not less than their number
   */
  record Tab(String view, int index) implements DropTarget {}

  /**
   * Beside the tabs of another view, with half of their room.
   *
   * @param view the other view
   * @param edge at which side
   */
  record Side(String view, Edge edge) implements DropTarget {}

  /**
   * Along a whole side of a window.
   *
   * @param window 0 for the main window, from 1 for those of its own
   * @param edge at which side
   */
  record Border(int window, Edge edge) implements DropTarget {}

  /**
   * In a window of its own.
   *
   * @param bounds where that lies
   */
  record OwnWindow(WindowBounds bounds) implements DropTarget {}
}
