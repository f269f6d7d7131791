/**
 * Actions: goals that take their time, with feedback and a result. The client
 * ({@link org.robotui.ros2.action.Ros2ActionClient}) sends any goal whose type is known by its definition; the server
 * ({@link org.robotui.ros2.action.Ros2ActionServer}) has its work done by a thread for each goal, or by a taker that
 * ends goals later.
 */
package org.robotui.ros2.action;
