package org.robotui.tests.crawl;

import java.util.Optional;
import org.robotui.api.bridge.BridgeTransform;
import org.robotui.data.Data;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.sensor.Battery;

/** The more one robot has left in its battery, the faster another one drives. */
final class CrawlTransform implements BridgeTransform {
  @Override
  public String id() {
    return "crawl";
  }

  @Override
  public String help() {
    return "The charge of a battery becomes a speed.";
  }

  @Override
  public Optional<Data> apply(Data value, Direction direction) {
    if (value instanceof Battery battery && direction == Direction.FORTH) {
      return Optional.of(VelocityCommand.planar(battery.charge(), 0));
    }
    throw new IllegalArgumentException("crawl takes Battery, not " + value.getClass().getSimpleName());
  }
}
