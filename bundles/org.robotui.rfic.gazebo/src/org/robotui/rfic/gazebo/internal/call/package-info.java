/** Services of a simulator, and what it has. */
package org.robotui.rfic.gazebo.internal.call;
