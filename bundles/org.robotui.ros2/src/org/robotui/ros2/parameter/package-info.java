/**
 * Parameters of nodes: reading, describing, setting and following those of others
 * ({@link org.robotui.ros2.parameter.Ros2Parameters}), and offering some
 * ({@link org.robotui.ros2.parameter.Ros2ParameterServer}).
 */
package org.robotui.ros2.parameter;
