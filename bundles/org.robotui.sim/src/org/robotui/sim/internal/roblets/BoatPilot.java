package org.robotui.sim.internal.roblets;

import java.util.List;
import org.robotui.roblets.body.BodyChange;
import org.robotui.roblets.body.BodySnapshot;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.brain.BrainRule;
import org.robotui.roblets.tree.BodyPath;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.sim.internal.roblets.BoatMessages.Order;
import org.robotui.sim.internal.roblets.BoatMessages.Thrust;
import org.robotui.sim.internal.roblets.BoatMessages.Turn;

/**
 * What the boat's brain does: whenever the helm says what is ordered, it steers by hand or from mark to mark, by what
 * the bodymap has of position and heading. It knows no other types of roblets than the messages.
 */
final class BoatPilot {
  private static final RecordMessage<Order> ORDER = RecordMessage.of(Order.class);
  private static final BodyPath LATITUDE = BodyPath.parse("gps/position/@latitude");
  private static final BodyPath LONGITUDE = BodyPath.parse("gps/position/@longitude");
  private static final BodyPath HEADING = BodyPath.parse("compass/heading/@heading");
  private static final BodyPath RATE = BodyPath.parse("compass/heading/@rate");
  private static final List<double[]> MARKS =
      List.of(new double[]{0, 120}, new double[]{120, 120}, new double[]{120, 0}, new double[]{0, 0});
  private static final double REACHED = 12;
  private static final double CRUISE = 0.6;
  private static final double FASTEST = 2.5;
  private static final double HARD_TURN = 0.3;
  private static final double DAMPING = 2;

  private int mark; // only on the thread of rules

  static BrainRule rule() {
    BoatPilot pilot = new BoatPilot();
    return BrainRule.when("steer", "helm/order", pilot::steer);
  }

  private void steer(BodyChange change, Brain brain) {
    Order order = ORDER.record(change.now().element());
    if (order.autopilot()) {
      toMark(change.body(), brain);
    } else {
      brain.say("rudder", new Turn(-Boat.LARGEST_RUDDER * Math.clamp(order.turn() / HARD_TURN, -1.0, 1.0)));
      brain.say("motor", new Thrust(Math.clamp(order.speed() / FASTEST, 0.0, 1.0)));
    }
  }

  /** Without position or heading the motor goes out by itself, as nobody says anything to it. */
  private void toMark(BodySnapshot body, Brain brain) {
    double latitude = body.number(LATITUDE).orElse(Double.NaN);
    double longitude = body.number(LONGITUDE).orElse(Double.NaN);
    double heading = body.number(HEADING).orElse(Double.NaN);
    if (Double.isNaN(latitude + longitude + heading)) {
      return;
    }
    double north = (latitude - Boat.START_LATITUDE) * Boat.METRES_A_DEGREE;
    double east = (longitude - Boat.START_LONGITUDE) * Boat.METRES_A_DEGREE
        * Math.cos(Math.toRadians(Boat.START_LATITUDE));
    double toEast = MARKS.get(mark)[0] - east;
    double toNorth = MARKS.get(mark)[1] - north;
    if (Math.hypot(toEast, toNorth) < REACHED) {
      mark = (mark + 1) % MARKS.size();
    }
    double bearing = Math.toDegrees(Math.atan2(toEast, toNorth));
    double off = Math.IEEEremainder(bearing - heading, 360);
    brain.say("rudder", new Turn(off - DAMPING * body.number(RATE).orElse(0)));
    brain.say("motor", new Thrust(CRUISE));
  }
}
