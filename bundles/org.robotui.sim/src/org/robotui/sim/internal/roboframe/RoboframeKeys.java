package org.robotui.sim.internal.roboframe;

import org.robotui.message.DefinitionException;
import org.robotui.message.DynamicMessage;
import org.robotui.message.MessageSchema;
import org.robotui.message.roboframe.BatteryStreamable;
import org.robotui.message.roboframe.GridStreamable;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.PictureStreamable;
import org.robotui.message.roboframe.PoseStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.TargetStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.roboframe.board.ChannelKey;

/** The keys of the robot's application. */
final class RoboframeKeys {
  static final ChannelKey<ScanStreamable> SCAN = ChannelKey.of("laser/scan", ScanStreamable.class);
  static final ChannelKey<OdometryStreamable> ODOMETRY = ChannelKey.of("odometry", OdometryStreamable.class);
  static final ChannelKey<PoseStreamable> POSE = ChannelKey.of("localisation/pose", PoseStreamable.class);
  static final ChannelKey<TFMessage> FRAMES = ChannelKey.of("tf", TFMessage.class);
  static final ChannelKey<GridStreamable> MAP = ChannelKey.of("map", GridStreamable.class);
  static final ChannelKey<BatteryStreamable> BATTERY = ChannelKey.of("battery", BatteryStreamable.class);
  static final ChannelKey<PictureStreamable> PICTURE = ChannelKey.of("camera/picture", PictureStreamable.class);
  static final ChannelKey<VelocityStreamable> VELOCITY = ChannelKey.of("drive/velocity", VelocityStreamable.class);
  static final ChannelKey<TargetStreamable> TARGET = ChannelKey.of("navigation/target", TargetStreamable.class);
  /** Types of this team alone; in millimetres. */
  static final MessageSchema BALL_TYPE =
      type("soccer/BallModel", "time stamp\nfloat32 x_mm\nfloat32 y_mm\nfloat32 distance_mm\nstring seen_by\n");
  static final MessageSchema TEAM_TYPE = type("soccer/TeamModel", "float32 mate_x_mm\nfloat32 mate_y_mm\n");
  static final ChannelKey<DynamicMessage> BALL = ChannelKey.of("soccer/ball", BALL_TYPE);
  static final ChannelKey<OdometryStreamable> MATE = ChannelKey.of("team/mate", OdometryStreamable.class);
  static final ChannelKey<DynamicMessage> TEAM = ChannelKey.of("team/model", TEAM_TYPE);

  private RoboframeKeys() {}

  private static MessageSchema type(String name, String text) {
    try {
      return MessageSchema.parse(name, text);
    } catch (DefinitionException e) {
      throw new IllegalStateException(e);
    }
  }
}
