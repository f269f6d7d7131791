/**
 * Types as ROS 2 describes them since Iron: names of three parts ({@link org.robotui.message.description.TypeName}),
 * descriptions without a syntax of their own ({@link org.robotui.message.description.TypeDescription}), and the sums by
 * which peers compare them ({@link org.robotui.message.description.TypeHash}). Nothing here reads files or waits.
 */
package org.robotui.message.description;
