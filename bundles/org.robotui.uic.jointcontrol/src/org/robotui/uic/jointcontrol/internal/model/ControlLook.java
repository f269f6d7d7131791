package org.robotui.uic.jointcontrol.internal.model;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.InputState;
import org.robotui.data.joint.JointControl.Source;
import org.robotui.ui.StateView;

/**
 * All that the view shows, at one moment.
 *
 * @param state of what is measured
 * @param joints all of them
 * @param drive how far the user is with driving
 * @param degrees whether angles are in degrees
 */
public record ControlLook(InputState state, Joints joints, DriveLook drive, boolean degrees) {
  /** Whether bars can be touched. */
  public boolean drivable() {
    return drive.driving() && state instanceof InputState.Live;
  }

  /** What stands at the right of the view's title. */
  public String note() {
    long safe = joints.byName().values().stream().filter(seen -> seen.state().source() == Source.SAFE).count();
    long faults = joints.byName().values().stream().filter(seen -> seen.state().faults() != 0).count();
    int count = joints.byName().size();
    return Stream.of(
        count == 0 ? "" : count == 1 ? "1 joint" : count + " joints",
        faults == 0 ? "" : faults == 1 ? "1 fault" : faults + " faults",
        safe == 0 ? "" : safe + " in safe state",
        count > 0 && !joints.described() ? "limits not known" : "",
        StateView.word(state))
        .filter(part -> !part.isEmpty()).collect(Collectors.joining(" \u00b7 "));
  }
}
