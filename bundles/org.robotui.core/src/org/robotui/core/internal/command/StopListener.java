package org.robotui.core.internal.command;

import org.robotui.api.command.Principal;

/** Hears of stops, on the thread of whoever stops or releases. Must not block. */
public interface StopListener {
  /** Nobody listens. */
  StopListener NONE = new StopListener() {
    @Override
    public void stopped(String robot, Principal by) {
      // nobody listens
    }

    @Override
    public void released(String robot) {
      // nobody listens
    }
  };

  /** A stop was latched. */
  void stopped(String robot, Principal by);

  /** A stop was released. */
  void released(String robot);
}
