package org.robotui.uic.alerts.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.api.alert.Alert;

/** What the user can do. Display thread. */
interface AlertActions {
  /** Says that these have been seen. */
  void acknowledge(List<Alert> alerts);

  /** Keeps these from being heard for some minutes; forever where there are none, and not at all for 0. */
  void mute(List<Alert> alerts, Optional<Long> minutes);

  /** Keeps all from being heard, as of {@link #mute}. */
  void muteAll(Optional<Long> minutes);
}
