/**
 * Actions: goals that take their time, with feedback and a result. The client
 * ({@link org.robotui.ros2.action.Ros2ActionClient}) sends any goal whose type is known by its definition; the server
 * ({@link org.robotui.ros2.action.Ros2ActionServer}) is as small as a simulated robot needs.
 */
package org.robotui.ros2.action;
