package org.robotui.rfic.smartsoft.internal.feed;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.api.session.PlacedFrames;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageException;
import org.robotui.message.RosValue;
import org.robotui.message.data.MessageRecord;
import org.robotui.rfic.smartsoft.internal.convert.SmartPlaces;
import org.robotui.rfic.smartsoft.internal.convert.SmartSensing;
import org.robotui.smartsoft.client.EventClient;
import org.robotui.smartsoft.client.EventMode;
import org.robotui.smartsoft.client.PushClient;
import org.robotui.smartsoft.client.PatternClient;
import org.robotui.smartsoft.naming.ServiceAddress;
import org.robotui.smartsoft.naming.ServiceName;
import org.robotui.smartsoft.naming.SmartPattern;
import org.robotui.smartsoft.object.CommType;

/** What is made of the objects of a service, by their types. */
final class FeedPlan {
  /** The type of objects that say where the robot is. */
  static final String BASE_STATE = "CommBasicObjects::CommBaseState";
  private static final Consumer<DynamicMessage> NOTHING = object -> {};

  private final SmartShared shared;
  private final PlacedFrames tree;
  private final RobotFrames frames;

  FeedPlan(SmartShared shared) {
    this.shared = shared;
    this.tree = shared.tree();
    this.frames = shared.frames();
  }

  /** A service of push, whose objects are of a type. */
  ServiceFeed push(ServiceName name, CommType type) {
    String path = name.path();
    return switch (type.name()) {
      case BASE_STATE -> feed(name, type, this::moved,
          outlet(path, Odometry.class, "where its wheels say that it is", false,
              m -> SmartPlaces.odometry(m, frames)),
          outlet(path + "/pose", PoseEstimate.class, "where it is, corrected by localisation", true,
              m -> SmartPlaces.estimate(m, frames)),
          outlet(path + "/battery", Battery.class, "its battery", false, SmartPlaces::battery));
      case "CommBasicObjects::CommMobileLaserScan" -> feed(name, type, m -> scanned(m, frames.device(path)),
          outlet(path, LaserScan.class, "what the scanner sees", false,
              m -> SmartSensing.scan(within(m, "laser_scan_pose.laser_scan"), frames.device(path))));
      case "CommBasicObjects::CommLaserScan" -> feed(name, type, m -> middle(path),
          outlet(path, LaserScan.class, "what the scanner sees; where it is, is not told", true,
              m -> SmartSensing.scan(m, frames.device(path))));
      case "CommBasicObjects::CommMobileIRScan" -> feed(name, type, m -> sensed(m, path),
          outlet(path, RangeReadings.class, "what the infrared sensors see", false,
              m -> SmartSensing.infrared(within(m, "irScan"), frames, path)));
      default -> onMap(name, type);
    };
  }

  private ServiceFeed onMap(ServiceName name, CommType type) {
    String path = name.path();
    return switch (type.name()) {
      case "CommNavigationObjects::CommGridMap" -> feed(name, type, NOTHING,
          outlet(path, GridMap.class, "the map", false, m -> SmartSensing.map(m, frames.map())));
      case "CommNavigationObjects::CommPlannerGoal" -> feed(name, type, NOTHING,
          outlet(path, Path.class, "the next point of its way, and its goal", false,
              m -> SmartPlaces.goal(m, frames.map())));
      case "CommBasicObjects::CommPose3dWithCovariance" -> feed(name, type, NOTHING,
          outlet(path, PoseEstimate.class, "where it is", true, m -> SmartPlaces.located(m, frames.map())));
      case "CommLocalizationObjects::CommAmclVisualizationInfo" -> feed(name, type, NOTHING,
          outlet(path, PoseArray.class, "a sample of the filter", true,
              m -> SmartPlaces.particles(m, frames.map())));
      case "CommLocalizationObjects::CommGpsFix" -> feed(name, type, m -> middle(path),
          outlet(path, GpsFix.class, "where its antenna is on earth", false,
              m -> SmartSensing.fix(m, frames.device(path))));
      default -> feed(name, type, NOTHING, records(path, "as the robot says it"));
    };
  }

  /** A service of event, activated with zeros. */
  ServiceFeed event(ServiceName name, CommType parameter, CommType event) {
    ServiceFeed.Opening opening = (address, taking) -> listening(address, parameter, taking);
    return new ServiceFeed(shared, name, event, opening, NOTHING,
        List.of(records(name.path(), "when it happens, activated with a parameter of zeros")));
  }

  private PatternClient listening(ServiceAddress address, CommType parameter, Consumer<ByteBuffer> taking)
      throws IOException {
    EventClient client = EventClient.connect(address, shared.links(), (number, event) -> taking.accept(event));
    try {
      client.activate(EventMode.CONTINUOUS, parameter.bytes(Map.of()));
      return client;
    } catch (MessageException e) {
      client.close();
      throw new IOException(e.getMessage(), e);
    }
  }

  private SmartOutlet<DynamicRecord> records(String path, String help) {
    return outlet(path, DynamicRecord.class, help, false, MessageRecord::new);
  }

  private <D extends Data> SmartOutlet<D> outlet(String port, Class<D> type, String help, boolean placed,
      SmartOutlet.Making<D> making) {
    return new SmartOutlet<>(shared, port, type, help, placed, making);
  }

  private ServiceFeed feed(ServiceName name, CommType type, Consumer<DynamicMessage> seeing,
      SmartOutlet<?>... outlets) {
    ServiceFeed.Opening opening = (address, taking) -> {
      PushClient client = PushClient.connect(address, shared.links(), taking::accept);
      client.subscribe(1);
      return client;
    };
    return new ServiceFeed(shared, name, type, opening, seeing, List.of(outlets));
  }

  /** A port that can show nothing, and says why. */
  SmartOutlet<DynamicRecord> unknown(ServiceName name, String reason) {
    SmartOutlet<DynamicRecord> outlet = records(name.path(), name.known().map(SmartPattern::word).orElse("")
        + " of objects that are not described");
    outlet.failed(reason);
    return outlet;
  }

  private static DynamicMessage within(DynamicMessage object, String path) {
    return object.at(path).filter(RosValue.Nested.class::isInstance).map(v -> ((RosValue.Nested) v).value())
        .orElseThrow(() -> new IllegalArgumentException("there is no " + path));
  }

  /** Where the robot is: what its wheels say, and where they began on the map. */
  private void moved(DynamicMessage state) {
    Optional<Stamp> stamp = shared.stamp(state, "timeStamp");
    RigidTransform driven = SmartPlaces.driven(state);
    tree.placed(frames.odom(), frames.base(), driven, stamp);
    tree.placed(frames.map(), frames.odom(), SmartPlaces.corrected(state).times(driven.inverse()), stamp);
  }

  private void scanned(DynamicMessage scan, FrameId frame) {
    moved(within(scan, "base_state"));
    tree.mounted(frame, SmartPlaces.pose(within(scan, "laser_scan_pose.sensor_pose")));
  }

  private void sensed(DynamicMessage scan, String path) {
    moved(within(scan, "baseState"));
    List<RigidTransform> mounts = SmartSensing.mounts(within(scan, "irScan"));
    for (int i = 0; i < mounts.size(); i++) {
      tree.mounted(frames.device(SmartSensing.sensor(path, i)), mounts.get(i));
    }
  }

  /** What does not say where it is, is taken to be in the middle of the robot. */
  private void middle(String path) {
    tree.mounted(frames.device(path), RigidTransform.IDENTITY);
  }
}
