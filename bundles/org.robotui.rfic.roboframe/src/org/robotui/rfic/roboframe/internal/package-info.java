/** Robots that run applications of RoboFrame. */
package org.robotui.rfic.roboframe.internal;
