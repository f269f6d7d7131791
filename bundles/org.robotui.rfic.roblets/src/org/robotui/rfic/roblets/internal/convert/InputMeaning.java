package org.robotui.rfic.roblets.internal.convert;

import org.robotui.data.command.VelocityCommand;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;

/** What roblets take that the house has a command for. */
public final class InputMeaning {
  private InputMeaning() {}

  public static boolean isVelocity(BodyForm form) {
    return form.as().equals("velocity");
  }

  /** Metres and radians in a second. */
  public static BodyElement velocity(String name, VelocityCommand command) {
    return BodyElement.of(name).with("vx", command.linear().x()).with("vy", command.linear().y()).with("wz",
        command.angular().z());
  }
}
