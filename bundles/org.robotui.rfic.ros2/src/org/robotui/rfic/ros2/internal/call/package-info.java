/** Services, parameters and nodes, for calling and browsing. */
package org.robotui.rfic.ros2.internal.call;
