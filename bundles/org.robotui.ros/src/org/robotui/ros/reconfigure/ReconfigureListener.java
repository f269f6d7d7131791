package org.robotui.ros.reconfigure;

/** Hears of a server. Called on I/O threads of its links; must not block. What it throws is logged. */
public interface ReconfigureListener {

  /**
   * The server described its parameters, for the first time or anew.
   *
   * @param description all of them
   */
  void onDescription(ServerDescription description);

  /**
   * The server told the values of its parameters, which anybody may have changed.
   *
   * @param values all of them
   */
  void onValues(ConfigValues values);

  /**
   * A listener that wants to know nothing, for those who ask the client.
   *
   * @return does nothing
   */
  static ReconfigureListener none() {
    return new ReconfigureListener() {
      @Override
      public void onDescription(ServerDescription description) {
        // the client keeps it
      }

      @Override
      public void onValues(ConfigValues values) {
        // the client keeps them
      }
    };
  }
}
