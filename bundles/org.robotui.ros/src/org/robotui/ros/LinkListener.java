package org.robotui.ros;

/** Hears of the state of links. */
@FunctionalInterface
public interface LinkListener {

  /**
   * A link changed its state. Called on the link's I/O thread, also several threads at once; must not block.
   *
   * @param event what changed
   */
  void onLink(LinkEvent event);

  /**
   * A listener that does nothing.
   *
   * @return the listener
   */
  static LinkListener none() {
    return event -> {};
  }
}
