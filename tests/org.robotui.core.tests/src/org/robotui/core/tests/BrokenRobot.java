package org.robotui.core.tests;

import java.util.List;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;

/** A type of robot interface that cannot make an instance. */
record BrokenRobot() implements RficType {
  @Override
  public Descriptor descriptor() {
    return new Descriptor("broken", "Broken robot", "A robot of the tests.", Schema.EMPTY, List.of());
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    throw new UnsupportedOperationException("no such device");
  }
}
