/**
 * A client of rosbridge (protocol 2), usable alone: {@code RosbridgeClient} subscribes, publishes and calls services;
 * {@code RosApi} asks the node {@code rosapi} what there is. Messages are trees of JSON, or the bytes of ROS where the
 * bridge sends them ({@code cbor-raw}); this library knows no type of ROS.
 */
package org.robotui.rosbridge;
