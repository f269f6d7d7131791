/** Places that a robot shall go to one after the other, edited in the scene. */
package org.robotui.uic.scene3d.internal.waypoint;
