package org.robotui.sim.internal.ros;

import org.robotui.net.call.Outcome;
import org.robotui.ros.Parameters;
import org.robotui.ros.XmlRpcValue;
import org.robotui.sim.internal.message.DriveLimit;
import org.robotui.sim.internal.robot.DriveLimits;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Reads the drive's limits from the node's private parameters, and writes there what was not set. */
final class LimitParameters {
  private static final Logger LOG = LoggerFactory.getLogger(LimitParameters.class);

  private final Parameters parameters;

  LimitParameters(Parameters parameters) {
    this.parameters = parameters;
  }

  DriveLimits read(DriveLimits defaults) {
    return DriveLimit.limits(limit -> number("~" + limit.name(), limit.of(defaults)));
  }

  private double number(String name, double otherwise) {
    double value = switch (parameters.get(name)) {
      case Outcome.Done<XmlRpcValue> done -> toNumber(done.value());
      case Outcome.Refused<XmlRpcValue> notSet -> otherwise;
      case Outcome.Failed<XmlRpcValue> failed -> otherwise;
      case Outcome.TimedOut<XmlRpcValue> late -> otherwise;
    };
    boolean usable = value > 0 && Double.isFinite(value);
    if (!usable) {
      LOG.warn("parameter {} must be a positive number: {} is used", name, otherwise);
    }
    double used = usable ? value : otherwise;
    if (parameters.set(name, new XmlRpcValue.Real(used)).toOptional().isEmpty()) {
      LOG.warn("parameter {} cannot be written to the master", name);
    }
    return used;
  }

  private static double toNumber(XmlRpcValue value) {
    return switch (value) {
      case XmlRpcValue.Real real -> real.value();
      case XmlRpcValue.Int number -> number.value();
      default -> Double.NaN;
    };
  }
}
