/** The type yarp: settings and sessions. */
package org.robotui.rfic.yarp.internal;
