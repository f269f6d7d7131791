package org.robotui.rfic.xbot.internal;

import java.util.List;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Intake;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.Port;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.StreamPort;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.Drives;
import org.robotui.data.control.LoopTiming;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.joint.Trajectory;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.sensor.Imu;
import org.robotui.data.status.Diagnostics;
import org.robotui.message.topic.TopicPorts;

/** The ports of every real-time control; those of sensors are offered as it has them. */
final class XbotPorts {
  static final StreamPort<JointState> JOINTS =
      new StreamPort<>("joints", JointState.class, Arity.MANY, "positions, velocities and efforts of the joints");
  static final StreamPort<JointControl> CONTROL =
      new StreamPort<>("control", JointControl.class, Arity.MANY,
          "how the joints are driven: references beside what is measured");
  static final StreamPort<JointModel> MODEL =
      new StreamPort<>("model", JointModel.class, Arity.MANY, "the joints with their limits, and their chains");
  static final StreamPort<RobotDescription> DESCRIPTION =
      new StreamPort<>("robot_description", RobotDescription.class, Arity.MANY,
          "what the robot is made of: the control's URDF and SRDF");
  static final StreamPort<ControlPlugins> PLUGINS =
      new StreamPort<>("plugins", ControlPlugins.class, Arity.MANY, "the control plugins and how they are doing");
  static final StreamPort<LoopTiming> TIMING =
      new StreamPort<>("timing", LoopTiming.class, Arity.MANY, "how well the control keeps its time");
  static final StreamPort<DynamicRecord> CYCLES =
      new StreamPort<>("cycles", DynamicRecord.class, Arity.MANY,
          "every cycle of the control with all joints, for recordings that name it and for plots", Intake.CHOSEN);
  static final StreamPort<Drives> DRIVES =
      new StreamPort<>("drives", Drives.class, Arity.MANY, "where the drives of the joints stand");
  static final StreamPort<Diagnostics> DIAGNOSTICS =
      new StreamPort<>("diagnostics", Diagnostics.class, Arity.MANY, "how the emergency stops stand");
  static final StreamPort<InteractiveMarkerSet> HANDLES =
      new StreamPort<>("task_handles", InteractiveMarkerSet.class, Arity.MANY,
          "handles for the frames that Cartesian plugins bring to poses");
  static final StreamPort<Trajectory> PLAN =
      new StreamPort<>("task_plan", Trajectory.class, Arity.MANY,
          "how the joints are expected to go to where a handle was dragged");
  static final CommandPort<JointCommand> COMMAND =
      new CommandPort<>("joint_command", JointCommand.class, Arity.MANY,
          "what the joints shall do, while the communication plugin runs");
  static final CallPort<PluginRequest, PluginReply> VERBS =
      new CallPort<>("plugin_verbs", PluginRequest.class, PluginReply.class, Arity.MANY,
          "starts, stops and reloads plugins; enables and disables drives", true);
  static final CallPort<ServiceRequest, ServiceReply> SERVICES =
      new CallPort<>("services", ServiceRequest.class, ServiceReply.class,
          Arity.MANY, "stop_plugins stops all plugins: for the stop_call of a robot's safety");

  static final List<Port> ALL =
      List.of(JOINTS, CONTROL, MODEL, PLUGINS, TIMING, DRIVES, DIAGNOSTICS, CYCLES, COMMAND, VERBS, SERVICES,
          TopicPorts.ACTIONS, TopicPorts.GRAPH, TopicPorts.MARKER_FEEDBACK);

  private XbotPorts() {}

  static StreamPort<Imu> imu(String sensor) {
    return new StreamPort<>("imu/" + sensor, Imu.class, Arity.MANY, "the inertial measurement unit " + sensor);
  }

  static StreamPort<Wrench> forceTorque(String sensor) {
    return new StreamPort<>("ft/" + sensor, Wrench.class, Arity.MANY, "the force-torque sensor " + sensor);
  }
}
