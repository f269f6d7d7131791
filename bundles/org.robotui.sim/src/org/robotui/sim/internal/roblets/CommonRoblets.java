package org.robotui.sim.internal.roblets;

import java.util.function.Supplier;
import org.robotui.roblets.roblet.OutputMessage;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletInfo;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.sim.internal.roblets.BoatMessages.Charge;
import org.robotui.sim.internal.roblets.BoatMessages.HeartBeat;
import org.robotui.sim.internal.roblets.BoatMessages.Heading;

/** Organs that boats and robots on wheels have alike. */
final class CommonRoblets {
  private CommonRoblets() {}

  static Roblet compass(Supplier<Heading> source) {
    return new SayingRoblet<>("compass", 10, Heading.class, source);
  }

  static Roblet battery(Supplier<Charge> source) {
    return new SayingRoblet<>("battery", 1, Charge.class, source);
  }

  /** Says that it is alive, as the one of the paper. */
  @OutputMessage(HeartBeat.class)
  @RobletInfo(name = "heart", frequency = 2)
  static final class HeartRoblet implements Roblet {
    @Override
    public void run(RobletSpeech speech) {
      speech.say(new HeartBeat(System.currentTimeMillis()));
    }
  }
}
