package org.robotui.sim.internal.roblets;

import java.util.List;
import java.util.function.Supplier;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.roblets.wire.RobletForm;

/** An organ that senses: it says one thing again and again. Where the value comes from is the robot's business. */
final class SayingRoblet<T extends Record> implements Roblet {
  private final RobletForm form;
  private final Supplier<T> source;

  SayingRoblet(String name, double frequency, Class<T> message, Supplier<T> source) {
    this.form = new RobletForm(name, frequency, List.of(RecordMessage.of(message).form()), List.of(), List.of());
    this.source = source;
  }

  @Override
  public RobletForm form() {
    return form;
  }

  @Override
  public void run(RobletSpeech speech) {
    speech.say(source.get());
  }
}
