package org.robotui.ros.msgs;

import java.util.Optional;

import org.robotui.ros.message.RecordCodec;
import org.robotui.ros.msgs.actionlib_msgs.GoalID;
import org.robotui.ros.msgs.actionlib_msgs.GoalStatus;
import org.robotui.ros.msgs.actionlib_msgs.GoalStatusArray;
import org.robotui.ros.msgs.diagnostic_msgs.DiagnosticArray;
import org.robotui.ros.msgs.diagnostic_msgs.DiagnosticStatus;
import org.robotui.ros.msgs.diagnostic_msgs.KeyValue;
import org.robotui.ros.msgs.dynamic_reconfigure.BoolParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.ConfigDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.DoubleParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Group;
import org.robotui.ros.msgs.dynamic_reconfigure.GroupState;
import org.robotui.ros.msgs.dynamic_reconfigure.IntParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.ParamDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.StrParameter;
import org.robotui.ros.msgs.geometry_msgs.Accel;
import org.robotui.ros.msgs.geometry_msgs.AccelStamped;
import org.robotui.ros.msgs.geometry_msgs.Point32;
import org.robotui.ros.msgs.geometry_msgs.Point;
import org.robotui.ros.msgs.geometry_msgs.PointStamped;
import org.robotui.ros.msgs.geometry_msgs.Polygon;
import org.robotui.ros.msgs.geometry_msgs.PolygonStamped;
import org.robotui.ros.msgs.geometry_msgs.Pose2D;
import org.robotui.ros.msgs.geometry_msgs.Pose;
import org.robotui.ros.msgs.geometry_msgs.PoseArray;
import org.robotui.ros.msgs.geometry_msgs.PoseStamped;
import org.robotui.ros.msgs.geometry_msgs.PoseWithCovariance;
import org.robotui.ros.msgs.geometry_msgs.PoseWithCovarianceStamped;
import org.robotui.ros.msgs.geometry_msgs.Quaternion;
import org.robotui.ros.msgs.geometry_msgs.QuaternionStamped;
import org.robotui.ros.msgs.geometry_msgs.Transform;
import org.robotui.ros.msgs.geometry_msgs.TransformStamped;
import org.robotui.ros.msgs.geometry_msgs.Twist;
import org.robotui.ros.msgs.geometry_msgs.TwistStamped;
import org.robotui.ros.msgs.geometry_msgs.TwistWithCovariance;
import org.robotui.ros.msgs.geometry_msgs.TwistWithCovarianceStamped;
import org.robotui.ros.msgs.geometry_msgs.Vector3;
import org.robotui.ros.msgs.geometry_msgs.Vector3Stamped;
import org.robotui.ros.msgs.geometry_msgs.Wrench;
import org.robotui.ros.msgs.geometry_msgs.WrenchStamped;
import org.robotui.ros.msgs.move_base_msgs.MoveBaseActionFeedback;
import org.robotui.ros.msgs.move_base_msgs.MoveBaseActionGoal;
import org.robotui.ros.msgs.move_base_msgs.MoveBaseActionResult;
import org.robotui.ros.msgs.move_base_msgs.MoveBaseFeedback;
import org.robotui.ros.msgs.move_base_msgs.MoveBaseGoal;
import org.robotui.ros.msgs.move_base_msgs.MoveBaseResult;
import org.robotui.ros.msgs.nav_msgs.GridCells;
import org.robotui.ros.msgs.nav_msgs.MapMetaData;
import org.robotui.ros.msgs.nav_msgs.OccupancyGrid;
import org.robotui.ros.msgs.nav_msgs.Odometry;
import org.robotui.ros.msgs.nav_msgs.Path;
import org.robotui.ros.msgs.roscpp.Logger;
import org.robotui.ros.msgs.rosgraph_msgs.Clock;
import org.robotui.ros.msgs.rosgraph_msgs.Log;
import org.robotui.ros.msgs.sensor_msgs.BatteryState;
import org.robotui.ros.msgs.sensor_msgs.CameraInfo;
import org.robotui.ros.msgs.sensor_msgs.ChannelFloat32;
import org.robotui.ros.msgs.sensor_msgs.CompressedImage;
import org.robotui.ros.msgs.sensor_msgs.FluidPressure;
import org.robotui.ros.msgs.sensor_msgs.Illuminance;
import org.robotui.ros.msgs.sensor_msgs.Image;
import org.robotui.ros.msgs.sensor_msgs.Imu;
import org.robotui.ros.msgs.sensor_msgs.JointState;
import org.robotui.ros.msgs.sensor_msgs.Joy;
import org.robotui.ros.msgs.sensor_msgs.LaserScan;
import org.robotui.ros.msgs.sensor_msgs.MagneticField;
import org.robotui.ros.msgs.sensor_msgs.NavSatFix;
import org.robotui.ros.msgs.sensor_msgs.NavSatStatus;
import org.robotui.ros.msgs.sensor_msgs.PointCloud2;
import org.robotui.ros.msgs.sensor_msgs.PointCloud;
import org.robotui.ros.msgs.sensor_msgs.PointField;
import org.robotui.ros.msgs.sensor_msgs.Range;
import org.robotui.ros.msgs.sensor_msgs.RegionOfInterest;
import org.robotui.ros.msgs.sensor_msgs.RelativeHumidity;
import org.robotui.ros.msgs.sensor_msgs.Temperature;
import org.robotui.ros.msgs.sensor_msgs.TimeReference;
import org.robotui.ros.msgs.std_msgs.ByteMultiArray;
import org.robotui.ros.msgs.std_msgs.ColorRGBA;
import org.robotui.ros.msgs.std_msgs.Float32MultiArray;
import org.robotui.ros.msgs.std_msgs.Float64MultiArray;
import org.robotui.ros.msgs.std_msgs.Header;
import org.robotui.ros.msgs.std_msgs.Int16MultiArray;
import org.robotui.ros.msgs.std_msgs.Int32MultiArray;
import org.robotui.ros.msgs.std_msgs.Int64MultiArray;
import org.robotui.ros.msgs.std_msgs.Int8MultiArray;
import org.robotui.ros.msgs.std_msgs.MultiArrayDimension;
import org.robotui.ros.msgs.std_msgs.MultiArrayLayout;
import org.robotui.ros.msgs.std_msgs.StdBool;
import org.robotui.ros.msgs.std_msgs.StdByte;
import org.robotui.ros.msgs.std_msgs.StdChar;
import org.robotui.ros.msgs.std_msgs.StdDuration;
import org.robotui.ros.msgs.std_msgs.StdEmpty;
import org.robotui.ros.msgs.std_msgs.StdFloat32;
import org.robotui.ros.msgs.std_msgs.StdFloat64;
import org.robotui.ros.msgs.std_msgs.StdInt16;
import org.robotui.ros.msgs.std_msgs.StdInt32;
import org.robotui.ros.msgs.std_msgs.StdInt64;
import org.robotui.ros.msgs.std_msgs.StdInt8;
import org.robotui.ros.msgs.std_msgs.StdString;
import org.robotui.ros.msgs.std_msgs.StdTime;
import org.robotui.ros.msgs.std_msgs.StdUInt16;
import org.robotui.ros.msgs.std_msgs.StdUInt32;
import org.robotui.ros.msgs.std_msgs.StdUInt64;
import org.robotui.ros.msgs.std_msgs.StdUInt8;
import org.robotui.ros.msgs.std_msgs.UInt16MultiArray;
import org.robotui.ros.msgs.std_msgs.UInt32MultiArray;
import org.robotui.ros.msgs.std_msgs.UInt64MultiArray;
import org.robotui.ros.msgs.std_msgs.UInt8MultiArray;
import org.robotui.ros.msgs.tf.TfMessage;
import org.robotui.ros.msgs.tf2_msgs.TFMessage;
import org.robotui.ros.msgs.trajectory_msgs.JointTrajectory;
import org.robotui.ros.msgs.trajectory_msgs.JointTrajectoryPoint;
import org.robotui.ros.msgs.visualization_msgs.InteractiveMarker;
import org.robotui.ros.msgs.visualization_msgs.InteractiveMarkerControl;
import org.robotui.ros.msgs.visualization_msgs.InteractiveMarkerFeedback;
import org.robotui.ros.msgs.visualization_msgs.InteractiveMarkerInit;
import org.robotui.ros.msgs.visualization_msgs.InteractiveMarkerPose;
import org.robotui.ros.msgs.visualization_msgs.InteractiveMarkerUpdate;
import org.robotui.ros.msgs.visualization_msgs.Marker;
import org.robotui.ros.msgs.visualization_msgs.MarkerArray;
import org.robotui.ros.msgs.visualization_msgs.MenuEntry;

/** Finds the compiled codec of a standard type. */
public final class StandardCodecs {

  private StandardCodecs() {
  }

  /**
   * Finds a codec.
   *
   * @param type the full name, such as {@code sensor_msgs/LaserScan}
   * @return empty if there is no compiled codec of this type: then a dynamic one does
   */
  public static Optional<RecordCodec<?>> forType(String type) {
    int slash = type.indexOf('/');
    return slash < 0
        ? Optional.empty()
        : Optional.ofNullable(find(type.substring(0, slash), type.substring(slash + 1)));
  }

  private static RecordCodec<?> find(String packageName, String name) {
    return switch (packageName) {
      case "actionlib_msgs" -> actionlibMsgs(name);
      case "diagnostic_msgs" -> diagnosticMsgs(name);
      case "dynamic_reconfigure" -> dynamicReconfigure(name);
      case "geometry_msgs" -> geometryMsgs(name);
      case "move_base_msgs" -> moveBaseMsgs(name);
      case "nav_msgs" -> navMsgs(name);
      case "roscpp" -> roscpp(name);
      case "rosgraph_msgs" -> rosgraphMsgs(name);
      case "sensor_msgs" -> sensorMsgs(name);
      case "std_msgs" -> stdMsgs(name);
      case "tf" -> tf(name);
      case "tf2_msgs" -> tf2Msgs(name);
      case "trajectory_msgs" -> trajectoryMsgs(name);
      case "visualization_msgs" -> visualizationMsgs(name);
      default -> null;
    };
  }

  private static RecordCodec<?> actionlibMsgs(String name) {
    return switch (name) {
      case "GoalID" -> GoalID.CODEC;
      case "GoalStatus" -> GoalStatus.CODEC;
      case "GoalStatusArray" -> GoalStatusArray.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> diagnosticMsgs(String name) {
    return switch (name) {
      case "KeyValue" -> KeyValue.CODEC;
      case "DiagnosticStatus" -> DiagnosticStatus.CODEC;
      case "DiagnosticArray" -> DiagnosticArray.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> dynamicReconfigure(String name) {
    return switch (name) {
      case "BoolParameter" -> BoolParameter.CODEC;
      case "Config" -> Config.CODEC;
      case "ConfigDescription" -> ConfigDescription.CODEC;
      case "DoubleParameter" -> DoubleParameter.CODEC;
      case "Group" -> Group.CODEC;
      case "GroupState" -> GroupState.CODEC;
      case "IntParameter" -> IntParameter.CODEC;
      case "ParamDescription" -> ParamDescription.CODEC;
      case "StrParameter" -> StrParameter.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> geometryMsgs(String name) {
    return switch (name) {
      case "Vector3" -> Vector3.CODEC;
      case "Point" -> Point.CODEC;
      case "Point32" -> Point32.CODEC;
      case "Quaternion" -> Quaternion.CODEC;
      case "Pose" -> Pose.CODEC;
      case "Pose2D" -> Pose2D.CODEC;
      case "PoseArray" -> PoseArray.CODEC;
      case "PoseStamped" -> PoseStamped.CODEC;
      case "PoseWithCovariance" -> PoseWithCovariance.CODEC;
      case "PoseWithCovarianceStamped" -> PoseWithCovarianceStamped.CODEC;
      case "PointStamped" -> PointStamped.CODEC;
      case "Polygon" -> Polygon.CODEC;
      case "PolygonStamped" -> PolygonStamped.CODEC;
      case "QuaternionStamped" -> QuaternionStamped.CODEC;
      case "Transform" -> Transform.CODEC;
      case "TransformStamped" -> TransformStamped.CODEC;
      case "Twist" -> Twist.CODEC;
      case "TwistStamped" -> TwistStamped.CODEC;
      case "TwistWithCovariance" -> TwistWithCovariance.CODEC;
      case "TwistWithCovarianceStamped" -> TwistWithCovarianceStamped.CODEC;
      case "Vector3Stamped" -> Vector3Stamped.CODEC;
      case "Wrench" -> Wrench.CODEC;
      case "WrenchStamped" -> WrenchStamped.CODEC;
      case "Accel" -> Accel.CODEC;
      case "AccelStamped" -> AccelStamped.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> moveBaseMsgs(String name) {
    return switch (name) {
      case "MoveBaseActionFeedback" -> MoveBaseActionFeedback.CODEC;
      case "MoveBaseActionGoal" -> MoveBaseActionGoal.CODEC;
      case "MoveBaseActionResult" -> MoveBaseActionResult.CODEC;
      case "MoveBaseFeedback" -> MoveBaseFeedback.CODEC;
      case "MoveBaseGoal" -> MoveBaseGoal.CODEC;
      case "MoveBaseResult" -> MoveBaseResult.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> navMsgs(String name) {
    return switch (name) {
      case "MapMetaData" -> MapMetaData.CODEC;
      case "OccupancyGrid" -> OccupancyGrid.CODEC;
      case "Odometry" -> Odometry.CODEC;
      case "Path" -> Path.CODEC;
      case "GridCells" -> GridCells.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> roscpp(String name) {
    return switch (name) {
      case "Logger" -> Logger.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> rosgraphMsgs(String name) {
    return switch (name) {
      case "Clock" -> Clock.CODEC;
      case "Log" -> Log.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> sensorMsgs(String name) {
    return switch (name) {
      case "LaserScan" -> LaserScan.CODEC;
      case "Range" -> Range.CODEC;
      case "Image" -> Image.CODEC;
      case "CompressedImage" -> CompressedImage.CODEC;
      case "RegionOfInterest" -> RegionOfInterest.CODEC;
      case "CameraInfo" -> CameraInfo.CODEC;
      case "BatteryState" -> BatteryState.CODEC;
      case "JointState" -> JointState.CODEC;
      case "Imu" -> Imu.CODEC;
      case "NavSatStatus" -> NavSatStatus.CODEC;
      case "NavSatFix" -> NavSatFix.CODEC;
      case "PointField" -> PointField.CODEC;
      case "PointCloud2" -> PointCloud2.CODEC;
      case "ChannelFloat32" -> ChannelFloat32.CODEC;
      case "PointCloud" -> PointCloud.CODEC;
      case "Joy" -> Joy.CODEC;
      case "Temperature" -> Temperature.CODEC;
      case "FluidPressure" -> FluidPressure.CODEC;
      case "Illuminance" -> Illuminance.CODEC;
      case "RelativeHumidity" -> RelativeHumidity.CODEC;
      case "MagneticField" -> MagneticField.CODEC;
      case "TimeReference" -> TimeReference.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> stdMsgs(String name) {
    return switch (name) {
      case "Header" -> Header.CODEC;
      case "Bool" -> StdBool.CODEC;
      case "Byte" -> StdByte.CODEC;
      case "Char" -> StdChar.CODEC;
      case "ColorRGBA" -> ColorRGBA.CODEC;
      case "Duration" -> StdDuration.CODEC;
      case "Empty" -> StdEmpty.CODEC;
      case "Float32" -> StdFloat32.CODEC;
      case "Float64" -> StdFloat64.CODEC;
      case "Int8" -> StdInt8.CODEC;
      case "Int16" -> StdInt16.CODEC;
      case "Int32" -> StdInt32.CODEC;
      case "Int64" -> StdInt64.CODEC;
      case "UInt8" -> StdUInt8.CODEC;
      case "UInt16" -> StdUInt16.CODEC;
      case "UInt32" -> StdUInt32.CODEC;
      case "UInt64" -> StdUInt64.CODEC;
      case "String" -> StdString.CODEC;
      case "Time" -> StdTime.CODEC;
      case "MultiArrayDimension" -> MultiArrayDimension.CODEC;
      case "MultiArrayLayout" -> MultiArrayLayout.CODEC;
      case "ByteMultiArray" -> ByteMultiArray.CODEC;
      case "Float32MultiArray" -> Float32MultiArray.CODEC;
      case "Float64MultiArray" -> Float64MultiArray.CODEC;
      case "Int8MultiArray" -> Int8MultiArray.CODEC;
      case "Int16MultiArray" -> Int16MultiArray.CODEC;
      case "Int32MultiArray" -> Int32MultiArray.CODEC;
      case "Int64MultiArray" -> Int64MultiArray.CODEC;
      case "UInt8MultiArray" -> UInt8MultiArray.CODEC;
      case "UInt16MultiArray" -> UInt16MultiArray.CODEC;
      case "UInt32MultiArray" -> UInt32MultiArray.CODEC;
      case "UInt64MultiArray" -> UInt64MultiArray.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> tf(String name) {
    return switch (name) {
      case "tfMessage" -> TfMessage.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> tf2Msgs(String name) {
    return switch (name) {
      case "TFMessage" -> TFMessage.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> trajectoryMsgs(String name) {
    return switch (name) {
      case "JointTrajectory" -> JointTrajectory.CODEC;
      case "JointTrajectoryPoint" -> JointTrajectoryPoint.CODEC;
      default -> null;
    };
  }

  private static RecordCodec<?> visualizationMsgs(String name) {
    return switch (name) {
      case "Marker" -> Marker.CODEC;
      case "MarkerArray" -> MarkerArray.CODEC;
      case "MenuEntry" -> MenuEntry.CODEC;
      case "InteractiveMarker" -> InteractiveMarker.CODEC;
      case "InteractiveMarkerControl" -> InteractiveMarkerControl.CODEC;
      case "InteractiveMarkerFeedback" -> InteractiveMarkerFeedback.CODEC;
      case "InteractiveMarkerInit" -> InteractiveMarkerInit.CODEC;
      case "InteractiveMarkerPose" -> InteractiveMarkerPose.CODEC;
      case "InteractiveMarkerUpdate" -> InteractiveMarkerUpdate.CODEC;
      default -> null;
    };
  }
}
