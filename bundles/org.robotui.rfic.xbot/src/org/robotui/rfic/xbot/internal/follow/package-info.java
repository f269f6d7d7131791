/** Trajectories that clients of other frameworks want to be followed, as goals of an action. */
package org.robotui.rfic.xbot.internal.follow;
