package org.robotui.ros2.graph;

import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Guid;
import org.robotui.rtps.VendorId;

/**
 * A node.
 *
 * @param name its whole name
 * @param participant the process that it is in
 * @param vendor whose DDS the process has
 * @param own whether it is of this context
 */
public record GraphNode(Ros2Name name, Guid participant, VendorId vendor, boolean own) {}
