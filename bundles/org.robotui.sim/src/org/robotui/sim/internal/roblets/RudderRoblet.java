package org.robotui.sim.internal.roblets;

import org.robotui.roblets.roblet.InputMessage;
import org.robotui.roblets.roblet.OutputMessage;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletInfo;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.sim.internal.roblets.BoatMessages.Turn;

/** The rudder: says its angle, and takes one. */
@InputMessage(Turn.class)
@OutputMessage(Turn.class)
@RobletInfo(frequency = 10)
final class RudderRoblet implements Roblet {
  private static final RecordMessage<Turn> TURN = RecordMessage.of(Turn.class);

  private final Boat boat;

  RudderRoblet(Boat boat) {
    this.boat = boat;
  }

  @Override
  public void run(RobletSpeech speech) {
    speech.say(new Turn(boat.rudder()));
  }

  @Override
  public void receive(String from, BodyElement message, RobletSpeech speech) {
    boat.rudder(TURN.record(message).angle());
  }
}
