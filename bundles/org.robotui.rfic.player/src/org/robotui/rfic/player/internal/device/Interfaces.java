package org.robotui.rfic.player.internal.device;

import java.util.Optional;
import org.robotui.player.layout.InterfaceLayout;
import org.robotui.player.wire.MessageType;

/** Gives each device the ports of its interface. What nothing else is made of becomes records. */
final class Interfaces {
  private Interfaces() {}

  static void furnish(DeviceFeed feed) {
    Optional<InterfaceLayout> layout = feed.around().layouts().byCode(feed.device().id().interfaceCode());
    switch (layout.map(InterfaceLayout::name).orElse("")) {
      case "position2d" -> Bases.position2d(feed);
      case "position3d" -> Bases.position3d(feed);
      case "laser" -> RangeFinders.laser(feed);
      case "sonar" -> RangeFinders.sonar(feed);
      case "ranger" -> new RangerPorts(feed);
      case "power" -> Simple.power(feed);
      case "camera" -> Simple.camera(feed);
      case "imu" -> Simple.imu(feed);
      case "gps" -> Simple.gps(feed);
      case "pointcloud3d" -> Simple.cloud(feed);
      case "fiducial" -> Simple.fiducial(feed);
      case "actarray" -> new Arm(feed);
      case "bumper" -> new BumperPorts(feed);
      case "map" -> new MapFetch(feed);
      case "planner" -> new PlannerPorts(feed);
      case "localize" -> new LocalizePorts(feed);
      default -> {}
    }
    layout.ifPresentOrElse(l -> rest(feed, l), () -> feed.records("", Optional.empty()));
  }

  /** A first kind of data that nothing was made of has the device's name, others their own behind it. */
  private static void rest(DeviceFeed feed, InterfaceLayout layout) {
    boolean first =
        layout.messages().stream().noneMatch(m -> m.type() == MessageType.DATA && feed.listensTo(m.subtype()));
    for (var message : layout.messages()) {
      if (message.type() == MessageType.DATA && !feed.listensTo(message.subtype())) {
        feed.records(first ? "" : "/" + message.name(), Optional.of(message));
        first = false;
      }
    }
  }
}
