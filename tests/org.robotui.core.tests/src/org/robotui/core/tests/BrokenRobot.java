package org.robotui.core.tests;

import java.util.List;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Port;

/** A type of robot interface that cannot make an instance. */
record BrokenRobot() implements RficType {
  @Override
  public String id() {
    return "broken";
  }

  @Override
  public String label() {
    return "Broken robot";
  }

  @Override
  public String help() {
    return "A robot of the tests.";
  }

  @Override
  public Schema schema() {
    return Schema.EMPTY;
  }

  @Override
  public List<Port> ports() {
    return List.of();
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    throw new UnsupportedOperationException("no such device");
  }
}
