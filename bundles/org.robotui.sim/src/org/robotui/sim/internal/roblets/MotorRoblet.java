package org.robotui.sim.internal.roblets;

import org.robotui.roblets.roblet.InputMessage;
import org.robotui.roblets.roblet.OutputMessage;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletInfo;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.sim.internal.roblets.BoatMessages.Power;
import org.robotui.sim.internal.roblets.BoatMessages.Thrust;

/** The motor: it goes out where nobody has said for a second how fast it shall run, also where this organ fails. */
@InputMessage(Thrust.class)
@OutputMessage(Power.class)
@RobletInfo(frequency = 5)
final class MotorRoblet implements Roblet {
  private static final RecordMessage<Thrust> THRUST = RecordMessage.of(Thrust.class);
  private static final long LASTS_NANOS = 1_000_000_000;
  private static final double TURNS = 2400;

  private final Boat boat;
  private long saidAt = System.nanoTime();

  MotorRoblet(Boat boat) {
    this.boat = boat;
  }

  @Override
  public void run(RobletSpeech speech) {
    if (System.nanoTime() - saidAt > LASTS_NANOS) {
      boat.throttle(0);
    }
    speech.say(new Power(boat.throttle(), boat.throttle() * TURNS));
  }

  @Override
  public void receive(String from, BodyElement message, RobletSpeech speech) {
    boat.throttle(THRUST.record(message).throttle());
    saidAt = System.nanoTime();
  }

  @Override
  public void stop() {
    boat.throttle(0);
  }
}
