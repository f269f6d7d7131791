/** Handles in the scene for frames that a Cartesian plugin brings to poses, and what is planned with them. */
package org.robotui.rfic.xbot.internal.task;
