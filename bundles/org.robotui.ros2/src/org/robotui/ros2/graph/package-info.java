/**
 * Who is in a domain of ROS 2 and has what: nodes, topics, services and actions with all their ends, as values of one
 * moment ({@link org.robotui.ros2.graph.GraphState}).
 */
package org.robotui.ros2.graph;
