/**
 * The transport of Gazebo (Ignition Transport 11 and newer) in pure Java, usable alone: {@code GazeboNode} finds who
 * publishes topics and serves requests, receives topics, publishes, asks and answers. Payloads are bytes of Protocol
 * Buffers; this library knows none of their types.
 */
package org.robotui.gazebo;
