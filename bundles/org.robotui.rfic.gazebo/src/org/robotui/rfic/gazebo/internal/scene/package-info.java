/** What stands in a world: its frames and its looks. */
package org.robotui.rfic.gazebo.internal.scene;
