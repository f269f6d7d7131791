package org.robotui.sim.internal.roblets;

import org.robotui.roblets.roblet.InputMessage;
import org.robotui.roblets.roblet.OutputMessage;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletInfo;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.sim.internal.roblets.BoatMessages.Autopilot;
import org.robotui.sim.internal.roblets.BoatMessages.Order;
import org.robotui.sim.internal.roblets.BoatMessages.Velocity;

/**
 * Where somebody steers by hand: says what was ordered. A velocity ends the autopilot, and holds for half a second; the
 * autopilot comes back only where that is ordered, so that a boat that was stopped stays so.
 */
@InputMessage(Velocity.class)
@InputMessage(Autopilot.class)
@OutputMessage(Order.class)
@RobletInfo(frequency = 10)
final class HelmRoblet implements Roblet {
  private static final RecordMessage<Velocity> VELOCITY = RecordMessage.of(Velocity.class);
  private static final RecordMessage<Autopilot> AUTOPILOT = RecordMessage.of(Autopilot.class);
  private static final long LASTS_NANOS = 500_000_000;
  private static final Order NONE = new Order(false, 0, 0);

  private Order order = new Order(true, 0, 0);
  private long saidAt = System.nanoTime();

  @Override
  public void run(RobletSpeech speech) {
    if (!order.autopilot() && System.nanoTime() - saidAt > LASTS_NANOS) {
      order = NONE;
    }
    speech.say(order);
  }

  @Override
  public void receive(String from, BodyElement message, RobletSpeech speech) {
    if (message.name().equals("autopilot")) {
      order = new Order(AUTOPILOT.record(message).on(), 0, 0);
    } else {
      Velocity velocity = VELOCITY.record(message);
      order = new Order(false, velocity.vx(), velocity.wz());
    }
    saidAt = System.nanoTime();
    speech.say(order);
  }
}
