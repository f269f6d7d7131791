package org.robotui.uic.jointcontrol.internal.model;

import java.util.Map;
import java.util.Optional;

/**
 * What the view shows of driving, at one moment.
 *
 * @param phase how far the user is
 * @param robot who is driven
 * @param moves what would move
 * @param aims by joint: where each is driven
 * @param jog whether joints move only while a hand holds
 * @param speed the share of their speed at which joints move at most
 * @param holder who else has control of the robot
 * @param mine whether the user has control of the robot
 * @param stoppedBy who latched the stop
 * @param owners plugins that own joints now, which then do not hear the user
 * @param blocked why joints cannot be driven now
 * @param told what is to be said: why driving ended, or what does not go well
 */
public record DriveLook(Phase phase, String robot, String moves, Map<String, Aim> aims, boolean jog, double speed,
    Optional<String> holder,
    boolean mine, Optional<String> stoppedBy, Optional<String> owners, Optional<String> blocked,
    Optional<String> told) {
  /** Copies the map. */
  public DriveLook {
    aims = Map.copyOf(aims);
  }

  /** Whether what the user does moves joints. */
  public boolean driving() {
    return phase == Phase.DRIVING;
  }
}
