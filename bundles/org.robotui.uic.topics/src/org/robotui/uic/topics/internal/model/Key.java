package org.robotui.uic.topics.internal.model;

import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;

/**
 * Which thing of which robot.
 *
 * @param robot the component that offers to be browsed
 * @param kind what it is
 * @param name the robot's name for it
 */
public record Key(String robot, Kind kind, String name) {
  Item item(String type) {
    return new Item(kind, name, type);
  }
}
